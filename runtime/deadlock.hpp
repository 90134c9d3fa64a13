#pragma once

#include "runtime/process.hpp"

#include <optional>
#include <string>
#include <vector>

namespace placedpar {

class Kernel;

/// A process that nothing will ever wake.
struct StuckProcess {
    std::string path;
    Activity activity;
    std::vector<std::string> channels; ///< the channels on which the process waits
    std::string where;                 ///< "slave.cpp:57": the file and line of its program
    std::string netlist = "";          ///< "farm.cfs:12", where it is declared; "" without a netlist
};

/// A channel on which a process waits for a partner that never comes.
struct StuckChannel {
    std::string name;
    std::string outputter, inputter; ///< paths, or a placeholder for an end that was never used
    std::string waiting;             ///< "outputter" or "inputter"
    std::string netlist = "";        ///< "farm.cfs:20", where it is connected; "" without a netlist
};

/// Shows which process waits for which when a simulation can go no further. It holds no addresses, so that two reports
/// of the same deadlock are equal.
struct Deadlock {
    std::vector<std::string> cycle; ///< paths, each waiting for the next and the last for the first; may be empty
    /// Why processes wait although their partners are ready: "a, b: until c is output, too"; "a: until in resets its
    /// end, too".
    std::vector<std::string> held_up;
    std::vector<StuckProcess> processes;
    std::vector<StuckChannel> channels;

    /// Returns the cycle and what is held up, then the table of processes and the table of channels.
    std::string text() const;
};

// REQUIRES for both functions: called at the end of a run, before the processes are unwound.

/// Reports all processes that have not ended.
Deadlock find_deadlock(const Kernel&);
/// Reports the processes that wait only for each other, or for processes that have ended, while other processes could
/// still continue. Returns nothing if there are none. A process that waits on a channel whose other end has not been
/// used yet is not counted: some process may still use that end.
std::optional<Deadlock> find_partial_deadlock(const Kernel&);

/// Returns the verb for an activity: "outputs", "alternates", ...
const char* name_of(Activity);

} // namespace placedpar
