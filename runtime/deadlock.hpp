#pragma once

#include "runtime/process.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace placedpar {

class AnyChannel;
class Kernel;

/// A process that waits for ever, because no event and no other process can wake it.
struct StuckProcess {
    std::string path;
    Activity activity;
    std::vector<std::string> channels; ///< the channels on which the process waits
    std::string where;                 ///< file and line of its program: "slave.cpp:57"
    std::string netlist = "";          ///< place of its declaration: "farm.cfs:12"; "" without a netlist
};

/// A channel on which a process waits for a partner that never comes.
struct StuckChannel {
    std::string name;
    std::string outputter, inputter; ///< paths of the processes, or a placeholder for an end that was never used
    std::string waiting;             ///< the end that waits: "outputter" or "inputter"; "" if none does
    std::string netlist = "";        ///< place of its connection: "farm.cfs:20"; "" without a netlist
};

/// Reports why a simulation cannot continue: which process waits for which. The report holds no memory addresses, so
/// two reports of the same deadlock are equal.
struct Deadlock {
    std::vector<std::string> cycle; ///< paths of processes of which each waits for the next, and the last for the
                                    ///< first; empty if there is no such cycle
    /// Reasons why processes wait although their partners are ready. Examples: "a, b: the message waits until it is
    /// taken on c, too, because one message goes to all these channels"; "in: no message can pass until sink, too,
    /// gives up its message and resets its end, because source gave up the message in the middle".
    std::vector<std::string> held_up;
    std::vector<StuckProcess> processes;
    std::vector<StuckChannel> channels;

    /// Returns the report as a text: the cycle, the channels that are held up, the table of processes, and the table of
    /// channels.
    std::string text() const;
};

// The next functions must be called at the end of a run, before the processes are unwound.

/// Reports all processes that have not ended.
Deadlock find_deadlock(const Kernel&);
/// Does the same for a native run, whose processes run on several kernels, one for each thread. REQUIRES: the kernels
/// are in the order of their numbers; the users of all channel ends have been declared (AnyChannel::expect_outputter).
Deadlock find_deadlock(std::span<const Kernel* const>);
/// Returns the users of these channels, named as in a report.
std::vector<StuckChannel> users_of(std::span<const AnyChannel* const>, const Kernel&);
/// Reports the processes that wait only for each other or for processes that have ended, while other processes could
/// still continue. Returns nothing if there are no such processes. A process that waits on a channel whose other end
/// was never used is not reported, because some process may still use that end.
std::optional<Deadlock> find_partial_deadlock(const Kernel&);

/// Returns the verb for an activity: "outputs", "alternates", and so on.
const char* name_of(Activity);

} // namespace placedpar
