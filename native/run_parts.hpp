#pragma once

#include "netlist/network/network.hpp"
#include "netlist/run_report.hpp"
#include "netlist/software.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace placedpar::native {

/// Counts messages, and the bytes that a link would carry for them.
struct Traffic {
    std::uint64_t messages = 0, bytes = 0;

    void add(std::uint64_t bytes_of_message) {
        ++messages;
        bytes += bytes_of_message;
    }
    void add(const Traffic& other) {
        messages += other.messages;
        bytes += other.bytes;
    }
};

/// The contribution of one thread or rank to the report of a native run. In a native run, processes run in real time on
/// several threads, or in several copies of the program, the ranks.
struct RunPart {
    RunResult result;
    std::vector<Measurement> measurements = {};
    std::vector<Time> waited = {};  ///< how long each process of the network waited; 0 for processes of other parts
    Time rested{};                  ///< how long the thread or rank had no process to run
    std::vector<Traffic> sent = {}; ///< the messages to each part; may be shorter than the number of parts
};

/// Returns how long each process of the network has waited.
std::vector<Time> times_waited(const Software&);

/// Puts the processes of a deadlock into the order of the netlist.
void sort_by_netlist(std::vector<StuckProcess>&, const Network&);

/// Joins the parts of a run into one report. The run is stuck if any part is stuck. Otherwise it is interrupted if any
/// part is interrupted, else completed. The report takes its deadlock from any part that has one. `noun` names a part
/// in the report, such as "thread" in "thread 0". `place_of_node`: the part of each node.
RunReport join_parts(const Network&, const std::vector<std::size_t>& place_of_node, const std::string& noun,
                     std::vector<RunPart>);

} // namespace placedpar::native
