#pragma once

#include "runtime/carrier.hpp"
#include "runtime/event.hpp"
#include "runtime/executive.hpp"
#include "runtime/process.hpp"

#include <cstdint>
#include <map>
#include <string>

namespace placedpar {
class Kernel;
} // namespace placedpar

namespace placedpar::hardware {

/// The costs of a thread of a native run, that is, a run of the processes in real time on the cores of a computer. They
/// are in cycles of the core's clock. `placedpar calibrate` measures them.
struct CoreCosts {
    std::int64_t clock_hz = usual_clock;
    Cycles communication{}; ///< an input or output between processes of the core
    Cycles crossing{};      ///< an input or output between processes of two cores
    Cycles switching{};     ///< a switch to the next process
    Cycles patience{};      ///< time for which the thread looks for work before it sleeps
    Cycles waking{};        ///< time to wake a sleeping thread
    Cycles oversleeping{};  ///< how much longer each pause lasts than requested, if the thread sleeps in pauses; 0: a
                            ///< message wakes the thread

    static constexpr std::int64_t usual_clock = 1'000'000'000; ///< so that a cycle is a nanosecond
};

/// Simulates a core of a computer that runs one thread of a native run. Such a simulation predicts the time of a native
/// run. The rules are those of the threads (native/group.hpp):
///
/// 1. A process runs until it waits or ends. Then the process that has been ready longest runs, whatever its priority.
/// Processes that another core has woken run first, but at most 8 in a row (TurnsOfWoken).
/// 2. If the core has had nothing to do for the time `patience`, the thread sleeps, and takes the time `waking` to
/// wake.
/// 3. A core with `oversleeping` > 0 is a rank of MPI, which no message can wake. Such a rank sleeps in pauses, and
/// looks for messages after each pause.
class ComputerCore final : public Executive {
public:
    /// Throws std::logic_error unless the clock is positive and no cost is negative.
    ComputerCore(Kernel&, std::string name, const CoreCosts&);

    std::int64_t clock_hz() const { return core_.clock_hz; }
    /// Returns how long the core has computed, without switches and waking.
    Time time_busy() const;

    Time tick(Priority) const override { return std::chrono::microseconds{1}; }
    bool begin_computing(Process&, Cycles, const CodeShape&) override;
    void make_ready(Process&) override;
    void leave(Process&, Process* successor) override;

    /// Calls an action of another core that may wake processes of this core.
    template <class Action>
    void wake_by(const Action& action) {
        is_woken_ = true;
        action();
        is_woken_ = false;
    }

private:
    struct Turn final : Event {
        explicit Turn(ComputerCore& c) : core(c) {}
        void happen() noexcept override { core.end_turn(); }
        ComputerCore& core;
    };
    Time duration(Cycles cycles) const { return duration_of(static_cast<std::int64_t>(cycles), core_.clock_hz); }
    Time time_to_start() const;
    Time rest_of_pause(Time waited) const;
    void take_next();
    void end_work();
    void end_turn();

    Kernel& kernel_;
    CoreCosts core_;
    ProcessQueue ready_, woken_; ///< `woken_`: processes that another core has woken
    bool is_woken_ = false;      ///< another core makes processes ready
    TurnsOfWoken turns_;
    Process* current_ = nullptr; ///< the process that has the core
    bool works_ = false;         ///< true: the current process computes; false: the core is switching to it
    Time idle_since_{}, began_{}, busy_{};
    Turn turn_{*this};
};

/// Carries the messages of any number of channels from one core to another. As in a native run, the outputter waits
/// until the inputter has taken the message from the memory. The inputter spends the time for its bytes.
class CoreLane final : public Carrier {
public:
    /// `to`: the core of the inputters. REQUIRES: bytes_per_second > 0.
    CoreLane(Kernel& kernel, ComputerCore& to, std::int64_t bytes_per_second)
        : kernel_(kernel), to_(to), bytes_per_second_(bytes_per_second) {}

    void output(AnyChannel&, const WireForm&, const SourceLocation&) override;
    void input(AnyChannel&, const SourceLocation&) override;
    bool message_waits(const AnyChannel&) const override;

private:
    /// The communication that is under way on a channel.
    struct Transfer {
        std::int64_t bytes = 0;     ///< length of the message
        bool is_full = false;       ///< a message waits
        Process* waiting = nullptr; ///< the process that waits for its partner
    };
    void wait_until(bool full, Transfer&, const AnyChannel&, const SourceLocation&);
    void turn(bool full, Transfer&);

    Kernel& kernel_;
    ComputerCore& to_;
    std::int64_t bytes_per_second_;
    std::map<const AnyChannel*, Transfer> transfers_;
};

} // namespace placedpar::hardware
