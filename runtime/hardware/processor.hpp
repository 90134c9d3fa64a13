#pragma once

#include "runtime/event.hpp"
#include "runtime/executive.hpp"
#include "runtime/process.hpp"
#include "runtime/time.hpp"

#include <cstdint>
#include <string>

namespace placedpar {
class Kernel;
} // namespace placedpar

namespace placedpar::hardware {

/// A transputer's processor: it shares itself out between its processes by the rules of the hardware
/// scheduler (Transputer Databook, 3rd ed. 1992, architecture 1.3).
///
/// 1. A high-priority process runs until it waits or ends. When one becomes ready, it pre-empts a low one.
/// 2. Low-priority processes run when no high one can, first in, first out. One that has run for a whole
///    timeslice period goes to the back of the queue when the period ends, if others wait.
/// 3. A pre-empted process goes on before the others of its queue.
/// 4. Between two computations or communications a program takes no time, but only the process that has the
///    processor executes it.
class Processor final : public Executive {
public:
    /// 5120 cycles of the 5 MHz input clock (databook), at every clock frequency of the processor.
    static constexpr Time timeslice = std::chrono::nanoseconds{1'024'000};
    /// The periods of the two clocks (INMOS ticks.inc).
    static constexpr Time high_tick = std::chrono::microseconds{1};
    static constexpr Time low_tick = std::chrono::microseconds{64};

    /// `channel_call`: cycles that the program's communication library adds to each input and output, on soft and hard
    /// channels alike; none for occam, which compiles them in line. Throws std::logic_error unless clock_hz > 0.
    Processor(Kernel&, std::string name, std::int64_t clock_hz = 20'000'000, Cycles channel_call = Cycles{0});

    std::int64_t clock_hz() const { return clock_hz_; }
    /// How long it has computed so far.
    Time time_busy() const;

    Time tick(Priority priority) const override { return priority == Priority::high ? high_tick : low_tick; }
    void compute(Cycles) override;
    void make_ready(Process&) override;
    /// A successor of the same priority goes on in the process's place, as after startp and by endp.
    void leave(Process&, Process* successor) override;

private:
    /// A stretch of time in which one process computes.
    struct Turn final : Event {
        explicit Turn(Processor& p) : processor(p) {}
        void happen() noexcept override { processor.end_turn(); }
        Processor& processor;
    };

    Time duration(Cycles) const;
    void dispatch();
    void go_on(Process&);
    void begin_turn();
    void stop_turn();
    void end_turn();
    void note_computing(const Process&) const;
    void account(const Process&, Time worked);
    void preempt();
    Time slice_end() const;

    Kernel& kernel_;
    std::int64_t clock_hz_;

    ProcessQueue high_, low_;      ///< the processes that wait for the processor
    Process* current_ = nullptr;   ///< the process that has it
    Process* preempted_ = nullptr; ///< the low-priority process that lost it to a high one
    Time dispatched_at_{};         ///< when the current low-priority process got it
    Time turn_began_{};
    Time busy_{}; ///< without the turn under way
    Turn turn_{*this};
};

} // namespace placedpar::hardware
