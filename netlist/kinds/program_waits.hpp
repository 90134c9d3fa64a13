#pragma once

#include "runtime/deadlock.hpp"

#include <compare>
#include <string>
#include <vector>

namespace placedpar {

struct Network; // netlist/network/network.hpp

/// Identifies an end of a channel that a booted program uses.
struct ProgramEnd {
    std::string channel; ///< "root.#80000100", a direction of a link "root.link[2] -> worker.link[1]", or a channel of
                         ///< the netlist that leads to a process
    bool is_output;
    auto operator<=>(const ProgramEnd&) const = default;
};

/// Describes a process of a booted program that still waits when nothing can happen any more.
struct ProgramWait {
    StuckProcess process;
    std::vector<ProgramEnd>
        awaited; ///< ends at which the process waits for a partner: the other ends of the channels that it uses now
    std::vector<ProgramEnd> ahead; ///< the ends that its code would use next
};

/// Adds processes of booted programs to a report: the processes, their channels, and a cycle if the report has none. A
/// cycle can contain processes of programs and processes of the netlist.
void add_program_waits(Deadlock&, const std::vector<ProgramWait>&, const Network&);

} // namespace placedpar
