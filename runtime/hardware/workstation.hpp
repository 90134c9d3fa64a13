#pragma once

#include "runtime/event.hpp"
#include "runtime/executive.hpp"
#include "runtime/process.hpp"

#include <cstdint>
#include <string>

namespace placedpar {
class Kernel;
} // namespace placedpar

namespace placedpar::hardware {

/// The processor of a host computer on a bus. It runs a process until the process waits. Then it takes the next ready
/// process, high priority first. Computing takes time, and so does input and output over the bus. Channels, PAR, ALT
/// and timers take no time, because their costs in the host's operating system were not measured.
class Workstation final : public Executive {
public:
    /// The clock frequency of a Sun 3/280's 68020 in Hz (data sheet).
    static constexpr std::int64_t sun_3_clock = 25'000'000;
    /// The tick of the clocks at both priorities, as in a 50 Hz Unix.
    static constexpr Time clock_tick = std::chrono::milliseconds{20};

    /// Throws std::logic_error unless clock_hz > 0.
    Workstation(Kernel&, std::string name, std::int64_t clock_hz = sun_3_clock);

    std::int64_t clock_hz() const { return clock_hz_; }
    /// Returns how long the workstation has computed so far, without waits for the bus.
    Time time_busy() const;

    Time tick(Priority) const override { return clock_tick; }
    bool begin_computing(Process&, Cycles, const CodeShape&) override;
    void make_ready(Process&) override;
    void leave(Process&, Process* successor) override;

private:
    struct Work final : Event {
        explicit Work(Workstation& w) : workstation(w) {}
        void happen() noexcept override;
        Workstation& workstation;
    };
    void take_next();
    void end_work();

    Kernel& kernel_;
    std::int64_t clock_hz_;
    ProcessQueue high_, low_;
    Process* current_ = nullptr;
    Time began_{}, busy_{};
    Work work_{*this};
};

} // namespace placedpar::hardware
