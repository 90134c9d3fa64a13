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
    std::vector<std::string> channels; ///< on which it waits
    std::string where;                 ///< "slave.cpp:57": the file and line of its program
    std::string netlist = "";          ///< "farm.cfs:12", where it is declared; "" without a netlist
};

/// A channel on which a process waits for a partner that never comes.
struct StuckChannel {
    std::string name;
    std::string outputter, inputter; ///< paths; "nobody yet" for an end that was never used
    std::string waiting;             ///< "outputter" or "inputter"
    std::string netlist = "";        ///< "farm.cfs:20", where it is connected; "" without a netlist
};

/// Which process waits for which when a simulation can go no further. It holds no addresses, so that two reports of the
/// same deadlock are equal.
struct Deadlock {
    std::vector<std::string> cycle; ///< paths, each waiting for the next and the last for the first; may be empty
    /// Why processes wait whose partners are there: "a, b: until c is output, too"; "a: until in resets its end, too".
    std::vector<std::string> held_up;
    std::vector<StuckProcess> processes;
    std::vector<StuckChannel> channels;

    /// The cycle, what is held up, then the table of processes and the table of channels.
    std::string text() const;
};

// REQUIRES, both: called at the end of a run, before the processes are unwound.

/// Of all processes that are left.
Deadlock find_deadlock(const Kernel&);
/// Of those that wait only for each other, or for processes that have ended, while others could still go on; nothing
/// where there are none. A process that waits at a channel's end that has had no partner so far is not counted: anyone
/// may come.
std::optional<Deadlock> find_partial_deadlock(const Kernel&);

/// "outputs", "alternates", ...
const char* name_of(Activity);

} // namespace placedpar
