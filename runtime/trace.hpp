#pragma once

#include "runtime/process.hpp"
#include "runtime/time.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace placedpar {

/// States that a place is in use from `since` on. A place is a row of the trace for hardware: a direction of a link, a
/// bus or a device.
struct PlaceTaken {
    const std::string& place;
    const std::string& subject;          ///< the user of the place: a channel, words on the bus, or a bus master that
                                         ///< waits for the bus
    Time since;                          ///< may be in the future
    const AnyChannel* channel = nullptr; ///< the channel, if the place is a direction of a link
};

/// States that the place is no longer in use from `until` on.
struct PlaceLeft {
    const std::string& place;
    Time until;                         ///< may be in the future
    std::uint64_t bytes = 0;            ///< number of bytes that a link carried without a break
    const Process* moves_for = nullptr; ///< process that had the bus to itself, if any
    Time since{};                       ///< time at which `moves_for` got the bus to itself
};

/// A channel for which a process waits. The process belongs to a program that an emulated transputer executes.
struct AwaitedByProgram {
    std::string channel; ///< the channel's word of memory, such as "root.#80000100", or a direction of a link
    std::string partner; ///< the process that used the other end last, or the direction of a link again; "" if unknown
};

/// States that a process changes its activity. The process is known only by its name. Either an emulated transputer
/// executes it, or it belonged to a native run that is over. (In a native run, processes run in real time on several
/// threads.) The activity is `computing` (the process has the processor), `ready`, a wait, `stopped` or `ended`.
struct ProgramTurn {
    const std::string& process; ///< "root.phil[2]", or, without a name, the address of its workspace: "root.#80000144"
    const std::string& place;   ///< the transputer, or the thread or program of a native run
    Activity activity;
    const std::vector<AwaitedByProgram>& awaited; ///< channels and partners of a wait
    bool awaits_timer;                            ///< the wait has a time limit, too
    const std::string& partner; ///< for `ready`: the process whose communication has ended the wait, if any
};

/// States that a process has done its part in the transfer of a message. This notice is only for native runs (in real
/// time on several threads), after their end.
struct MessagePart {
    const std::string& channel;
    std::uint64_t message;      ///< number of the message in the run
    const std::string& process; ///< the outputter or the inputter
    const std::string& partner; ///< the process at the other end, or its ancestor at the outermost level; "" if unknown
    bool is_input;              ///< true: the inputter's part of the message; false: the outputter's part
};

/// Receives the trace of a run: notices of what each process and each link or bus does, and when. A notice about a
/// process or a place holds until the next notice about the same process or place. The calls come during the run, and
/// must not change the simulation.
///
/// 1. Notices come in the order of their times. An operation that takes no time begins and ends with two notices of the
/// same time.
/// 2. Processes, channels and their data may be destroyed after the call. However, a process that waits exists until it
/// continues.
class TraceSink {
public:
    /// States that a process changes its activity:
    ///   starting          The process exists; its program begins when its turn comes. For a process that was made
    ///                     before the run, this notice comes when the run begins, perhaps after a notice `ready`.
    ///   delayed, ...      The process waits. Its activity and awaited_channels() say for what.
    ///   ready             The wait or the computation of the process is over, or the process has lost its processor.
    ///                     A process on a processor has no such notice at the end of a PAR. No process has such a
    ///                     notice for a delay without a wait.
    ///   executing         A wait is over, and the program runs again. The process's activity and awaited_channels()
    ///                     are still those of the wait. In a native run, such a notice also comes when the process
    ///                     begins.
    ///   computing         The processor works for the process. This may begin before the program runs again, because
    ///                     a processor already spends time on a process that is ready.
    ///   moving            The process moves words over a bus, or waits for the bus.
    ///   ended             This is the last notice about the process.
    virtual void turns(const Process&, Activity, Time) = 0;
    /// States the activity of a process that is known only by its name. After a process has ended, another process may
    /// have the same name.
    virtual void program_turns(const ProgramTurn&, Time) {}
    /// States that the outputter or the inputter has done its part in the transfer of a message. The notices of the two
    /// parts come in any order.
    virtual void program_communicates(const MessagePart&, Time) {}
    /// States that a message was transferred from the channel's outputter to its inputter.
    virtual void communicated(const AnyChannel&, Time) = 0;
    virtual void takes(const PlaceTaken&, Time now) = 0;
    virtual void leaves(const PlaceLeft&, Time now) = 0;
    /// States that the work is over. The remaining processes are still in their waits. No notice follows.
    virtual void over(Time) = 0;
    /// States that the trace ends here, although the work continues, and why. Called in place of over().
    virtual void ends_early(Time, const std::string&) {}

protected:
    ~TraceSink() = default;
};

} // namespace placedpar
