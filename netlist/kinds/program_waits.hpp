#pragma once

#include "runtime/deadlock.hpp"

#include <compare>
#include <string>
#include <vector>

namespace placedpar {

struct Network; // netlist/network/network.hpp

/// Identifies an end of a channel that a booted program, that is, the machine code of an emulated transputer, uses.
struct ProgramEnd {
    std::string channel; ///< a channel in memory, "root.#80000100"; a direction of a link, "root.link[2] ->
                         ///< worker.link[1]"; or the name of a channel to a process of the netlist
    bool is_output;
    auto operator<=>(const ProgramEnd&) const = default;
};

/// Describes a process of a booted program that waits when the run has ended in a deadlock.
struct ProgramWait {
    StuckProcess process;
    std::vector<ProgramEnd> awaited; ///< the ends at which the partners for which the process waits would have to act
    std::vector<ProgramEnd> ahead;   ///< the ends that the process's code would use next
};

/// Adds to the report of a deadlock the waiting processes of booted programs, and their channels. If the report has no
/// cycle of processes that wait for each other, adds such a cycle, if there is one. It can contain processes of
/// programs and processes of the netlist.
void add_program_waits(Deadlock&, const std::vector<ProgramWait>&, const Network&);

} // namespace placedpar
