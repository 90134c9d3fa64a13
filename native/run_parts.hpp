#pragma once

#include "netlist/network/network.hpp"
#include "netlist/run_report.hpp"
#include "netlist/software.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace placedpar::native {

/// What one thread or rank contributes to the report of a run.
struct RunPart {
    RunResult result;
    std::vector<Measurement> measurements = {};
    std::vector<Time> waited = {}; ///< for how long each process of the network waited; 0 for those of other parts
    Time rested{};                 ///< for how long no process was ready
};

/// Returns for how long the processes of the software have waited.
std::vector<Time> times_waited(const Software&);

/// Puts the processes of a deadlock into the order of the netlist.
void sort_by_netlist(std::vector<StuckProcess>&, const Network&);

/// Joins the parts of a run. A run is stuck if a part is, and interrupted if another part is; else it is completed. The
/// deadlock is that of any part that has one. `noun`: what the parts are called in the report, as in "thread 0".
/// `place_of_node`: the part of each node.
RunReport join_parts(const Network&, const std::vector<std::size_t>& place_of_node, const std::string& noun,
                     std::vector<RunPart>);

} // namespace placedpar::native
