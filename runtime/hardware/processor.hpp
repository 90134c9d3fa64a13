#pragma once

#include "runtime/event.hpp"
#include "runtime/process.hpp"
#include "runtime/time.hpp"

#include <string>

namespace placedpar {

/// A transputer's processor: it shares itself out between its processes by the rules of the hardware
/// scheduler (Transputer Databook, 3rd ed. 1992, architecture 1.3).
///
/// - A high-priority process runs until it waits or ends. One that becomes ready pre-empts a low one.
/// - Low-priority processes run when no high one can, first in, first out. One that has run for a whole
///   timeslice period goes to the back of the queue when the period ends, if others wait.
/// - A pre-empted process goes on before the others of its queue.
///
/// The program between two computations and communications takes no time, but only the process that has the
/// processor executes it.
class Processor {
public:
    /// 5120 cycles of the 5 MHz input clock (databook), whatever the processor's own clock.
    static constexpr Time timeslice = std::chrono::nanoseconds{1'024'000};

    /// `channel_call`: what the program's communication library charges for each operation on a hard channel,
    /// on top of the instructions; none for occam, which compiles them in line. Throws std::logic_error unless
    /// clock_hz > 0.
    Processor(Kernel&, std::string name, std::int64_t clock_hz, Cycles channel_call = Cycles{0});

    const std::string& name() const { return name_; }
    std::int64_t clock_hz() const { return clock_hz_; }
    Cycles channel_call() const { return channel_call_; }
    /// Time for which it has computed so far.
    Time time_busy() const;

    /// The running process computes. REQUIRES: it is the one that has this processor.
    /// Throws std::logic_error when cycles < 0.
    void compute(Cycles);

    // For the kernel.
    void make_ready(Process&);
    /// The process that has the processor waits.
    void release(Process&);
    /// The process that has the processor ends. `parent`, if not null, waited in a PAR for it as the last
    /// component: at the same priority it goes on in its place, as the instruction endp has it.
    void end(Process&, Process* parent);

private:
    struct Turn final : Event {
        explicit Turn(Processor& p) : processor(p) {}
        void happen() noexcept override { processor.end_turn(); }
        Processor& processor;
    };

    void dispatch();
    void begin_turn();
    void stop_turn();
    void end_turn();
    void account(const Process&, Time worked);
    void preempt();
    Time slice_end() const;

    Kernel& kernel_;
    std::string name_;
    std::int64_t clock_hz_;
    Cycles channel_call_;

    ProcessQueue high_, low_;
    Process* current_ = nullptr;
    Process* preempted_ = nullptr;
    Time dispatched_at_{}; ///< when the current low-priority process got the processor
    Time turn_began_{};
    Time busy_{};
    Turn turn_{*this};
};

/// The running process computes for so many cycles of its processor. A process that is not placed is
/// infinitely fast.
void compute(Cycles);

/// What one operation on a hard channel costs the running process before its message moves: the call of
/// its communication library, and the instruction `in` or `out`.
void charge_channel_call();

} // namespace placedpar
