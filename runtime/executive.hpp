#pragma once

#include "runtime/process.hpp"
#include "runtime/protocol.hpp"
#include "runtime/source_location.hpp"
#include "runtime/time.hpp"

#include <cstdint>
#include <functional>
#include <string>
#include <utility>

namespace placedpar {

/// The costs of occam's operations (communication, PAR, ALT, timers) on a processor, in cycles of its clock. For its
/// other work, a program states the cycles in calls of compute().
struct OperationCosts {
    // The first members are used most often, so they are in the executive's first cache line.
    Cycles soft_communication{}; ///< an input or output on a soft channel (both processes on one processor), without
                                 ///< the copy of its message
    Cycles soft_word_output{};   ///< an output of one byte or one word on a soft channel, including the copy
    Cycles hard_communication{}; ///< an input or output on a hard channel (over a link or bus), for each part of the
                                 ///< message
    Cycles word_outside{};       ///< additional cycles of each access to a word of memory outside the chip
    Cycles copied_word{}; ///< each word of a message on a soft channel, unless `soft_word_output` includes its copy;
                          ///< paid by the process that arrives second
    std::int64_t bytes_in_a_word = 4;

    Cycles start_component{}; ///< for each component of a PAR, except the last, which takes the parent's place
    Cycles run_component{};   ///< replaces `start_component` if the component's priority differs from its parent's, as
                              ///< in a PRI PAR
    Cycles end_component{};   ///< paid by the component when it ends

    Cycles timer_read{};
    Cycles timer_wait{};      ///< a wait for a later time
    Cycles timer_wait_past{}; ///< a wait for a time that has passed

    Cycles alternation_start{};
    Cycles enable_guard{};           ///< a SKIP guard, or an input whose message waits
    Cycles enable_guard_not_ready{}; ///< an input without a message, or a guard that is FALSE
    Cycles enable_timeout{};
    Cycles alternation_wait_ready{}; ///< waiting for a guard, if one is ready
    Cycles alternation_wait{};       ///< waiting for a guard, if none is ready
    Cycles disable_guard{};
    Cycles disable_timeout{};
    Cycles alternation_end{};

    Cycles attempt{};       ///< additional cost of a communication that may be given up
    Cycles reset_channel{}; ///< reset of an end after a message was given up

    /// Returns whether a single instruction, `outbyte` or `outword`, outputs the message.
    constexpr bool is_one_word(const WireForm& form) const {
        return form.parts() == 1 && (form[0] == 1 || form[0] == bytes_in_a_word);
    }
    /// Returns the cost of copying a message, rounded up to whole words.
    constexpr Cycles copy(std::int64_t bytes) const {
        return (bytes + bytes_in_a_word - 1) / bytes_in_a_word * copied_word;
    }
};

/// An executive is a processor that divides its time among its processes: a transputer, a bus master or a workstation.
/// occam's constructs (channels, PAR, ALT, timers) use the hardware only through this interface. A process without an
/// executive is infinitely fast.
///
/// An implementation must keep these rules:
/// 1. After make_ready(p), process p can continue. The executive calls Kernel::enqueue(p) once, immediately or when p's
/// turn comes. From then on p has the executive, and p continues at the same virtual time.
/// 2. p keeps the executive until leave(p), that is, until p waits or ends. Only while p has the executive may it
/// compute.
/// 3. If begin_computing(p) returns false, the executive calls Kernel::enqueue(p) once, when the work is done.
/// Meanwhile it may execute other processes. If begin_computing(p) returns true, the work is already done:
/// Kernel::pass_time has advanced the time, or there was no work.
/// 4. make_ready(), leave() and begin_computing() do not wait. make_ready() and leave() do not throw, because events
/// and ending processes call them.
/// 5. The operations that a program repeats while it polls (SKIP guards, waits for a past time) must take time.
/// Otherwise virtual time stands still while the program polls.
class Executive {
public:
    virtual ~Executive() = default;
    Executive(const Executive&) = delete;
    Executive& operator=(const Executive&) = delete;

    const std::string& name() const { return name_; }
    const OperationCosts& costs() const { return costs_; }
    /// Returns the length of a tick of the clock that processes of this priority read.
    virtual Time tick(Priority) const = 0;

    /// Starts a computation of the running process. Returns whether the computation is already done. The shape states
    /// where the computation can be interrupted. Throws std::logic_error if the cycles or `words_outside` are negative,
    /// or if another member of the shape is less than 1. REQUIRES: the process has this executive.
    virtual bool begin_computing(Process&, Cycles, const CodeShape&) = 0;
    /// Returns whether a fault has stopped the executive and all its processes for ever.
    virtual bool halted() const { return false; }

    // The next functions are for the kernel.
    virtual void make_ready(Process&) = 0;
    /// Called when the process that has the executive waits or has ended. The function must make `successor` ready,
    /// unless it is null. At the start of a PAR, the successor is the component that takes the process's place. At the
    /// end of a PAR, the successor is the parent.
    virtual void leave(Process&, Process* successor) = 0;

protected:
    Executive(std::string name, const OperationCosts& costs) : name_(std::move(name)), costs_(costs) {}

    /// Returns how much longer the process must compute before its program continues. This time is stored in the
    /// process, but only the process's executive reads and writes it.
    static Time& work_left(Process& p) { return p.work_left_; }
    /// Returns the shape of the process's current computation. The process stores the shape, too.
    static CodeShape& grain(Process& p) { return p.grain_; }

private:
    std::string name_;
    OperationCosts costs_;
};

/// Lets the running process compute for this number of cycles of its executive. Without an executive the computation
/// takes no time. The shape states at which points the process can leave the executive. These points are counted back
/// from the end of the computation. Throws std::logic_error as Executive::begin_computing does.
void compute(Cycles, const CodeShape& = {});

/// Stops the running process for ever, as occam's STOP does. Other processes continue, but a process that waits for the
/// stopped process waits for ever, even the parent of its PAR. A run that ends with stopped processes ends as in a
/// deadlock.
[[noreturn]] void stop(const SourceLocation& = SourceLocation::current());

/// Makes the running process compute for the cycles that an operation costs: `charge(self,
/// &OperationCosts::timer_read)`.
template <class Cost>
void charge(Process& self, Cost cost) {
    if (Executive* executive = self.executive())
        self.compute(std::invoke(cost, executive->costs()), {});
}

/// Makes the process compute for the cycles of the cost, and then begin the communication.
template <class Cost>
void charge_and_communicate(Process& self, Cost cost, Communication& communication) {
    Executive* executive = self.executive();
    self.compute_and_communicate(communication, executive ? std::invoke(cost, executive->costs()) : Cycles{});
}

} // namespace placedpar
