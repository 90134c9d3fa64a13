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

/// What the operations of a program cost on an executive, in cycles of its clock. The program's own work is not
/// among them: it states that by compute().
struct OperationCosts {
    // What a computation and a communication on a link look at first, so that it stands in the executive's first line
    // of the cache.
    Cycles soft_communication{}; ///< an input or output on a soft channel, before its message moves
    Cycles soft_word_output{};   ///< the same for an output of one byte or one word, its copy included
    Cycles hard_communication{}; ///< an input or output on a hard channel, for each part of the message
    Cycles word_outside{};       ///< of what a process computes with (CodeShape), beyond the cycle that it counts
    Cycles copied_word{};        ///< on a soft channel, paid by the process that arrives second (see soft_word_output)
    std::int64_t bytes_in_a_word = 4;

    Cycles start_component{}; ///< of a PAR, for each but the last, which its process runs itself
    Cycles run_component{};   ///< the same, of another priority than its process, as the high one of a PRI PAR
    Cycles end_component{};   ///< paid by the component when it ends

    Cycles timer_read{};
    Cycles timer_wait{};      ///< for a time that is still to come
    Cycles timer_wait_past{}; ///< for a time that has come already

    Cycles alternation_start{};
    Cycles enable_guard{};           ///< a SKIP guard, or an input whose message waits
    Cycles enable_guard_not_ready{}; ///< an input without a message, or a guard that is FALSE
    Cycles enable_timeout{};
    Cycles alternation_wait_ready{}; ///< when a guard is ready
    Cycles alternation_wait{};       ///< when none is
    Cycles disable_guard{};
    Cycles disable_timeout{};
    Cycles alternation_end{};

    Cycles attempt{};       ///< a communication that may be given up, besides what it costs as such
    Cycles reset_channel{}; ///< an end of it, after that

    /// Whether an output of the message is an instruction of its own, `outbyte` or `outword`.
    constexpr bool is_one_word(const WireForm& form) const {
        return form.parts() == 1 && (form[0] == 1 || form[0] == bytes_in_a_word);
    }
    /// Copying a message, rounded up to whole words.
    constexpr Cycles copy(std::int64_t bytes) const {
        return (bytes + bytes_in_a_word - 1) / bytes_in_a_word * copied_word;
    }
};

/// Executes processes and shares itself out between them: a transputer's processor, a bus master, a workstation.
/// It stands between occam's words (channels, PAR, ALT, timers), which only know this interface, and the hardware.
/// A process without an executive is infinitely fast.
///
/// What an implementation must keep to:
/// 1. make_ready(p) tells it that p can go on. It answers with one Kernel::enqueue(p), at once or when p's turn comes.
///    From that call on p has the executive; p goes on at that same moment of virtual time.
/// 2. p keeps the executive until it leaves it, to wait or because it has ended. While it has it, p may compute.
/// 3. begin_computing(p) is answered with one Kernel::enqueue(p), when the work is done; the executive may take itself
///    from p in the meantime. Or it returns true: the work is done already, by Kernel::pass_time or because there was
///    none.
/// 4. make_ready and leave neither wait nor throw: events call them, and processes that are ending. begin_computing
///    does not wait.
/// 5. A program may poll, by SKIP guards or by waiting for a past time. The operations that it repeats must take
///    time, or virtual time stands still for as long as it polls.
class Executive {
public:
    virtual ~Executive() = default;
    Executive(const Executive&) = delete;
    Executive& operator=(const Executive&) = delete;

    const std::string& name() const { return name_; }
    const OperationCosts& costs() const { return costs_; }
    /// The period of the clock that processes of this priority read.
    virtual Time tick(Priority) const = 0;

    /// The process, which is running, computes for so many cycles from now on; returns whether it has done so already.
    /// REQUIRES: it has this executive. Throws std::logic_error when cycles < 0 or one of the grain's < 1.
    virtual bool begin_computing(Process&, Cycles, const CodeShape&) = 0;
    /// Whether it has stopped for ever, by a fault, with all its processes.
    virtual bool halted() const { return false; }

    // For the kernel.
    virtual void make_ready(Process&) = 0;
    /// The process, which has the executive, waits or has ended. `successor` is to be made ready now, if it is not
    /// null: the component of its PAR that a process runs in its own place, or the process that waited in a PAR for
    /// the one that has ended as the last component.
    virtual void leave(Process&, Process* successor) = 0;

protected:
    Executive(std::string name, const OperationCosts& costs) : name_(std::move(name)), costs_(costs) {}

    /// How much longer the process must compute before its program goes on: a note kept with the process, which only
    /// its executive reads and writes.
    static Time& work_left(Process& p) { return p.work_left_; }
    /// The shape of the code of that work, kept in the same way.
    static CodeShape& grain(Process& p) { return p.grain_; }

private:
    std::string name_;
    OperationCosts costs_;
};

/// The running process computes for so many cycles of its executive; without one, for no time. The grain says where it
/// can be left: counted from the end, at which it can. Throws std::logic_error when cycles < 0 or one of the grain's
/// < 1.
void compute(Cycles, const CodeShape& = {});

/// occam's STOP: the running process does nothing any more, while others go on. Who waits for it waits for ever, as the
/// process of whose PAR it is a component. A run at whose end it is left ends as in a deadlock.
[[noreturn]] void stop(const SourceLocation& = SourceLocation::current());

/// The running process pays for an operation: `cost`, called with its executive's costs, says how much. For example
/// `charge(self, &OperationCosts::timer_read)`.
template <class Cost>
void charge(Process& self, Cost cost) {
    if (Executive* executive = self.executive())
        self.compute(std::invoke(cost, executive->costs()), {});
}

/// Charges the cost, and then lets the process communicate.
template <class Cost>
void charge_and_communicate(Process& self, Cost cost, Communication& communication) {
    Executive* executive = self.executive();
    self.compute_and_communicate(communication, executive ? std::invoke(cost, executive->costs()) : Cycles{});
}

} // namespace placedpar
