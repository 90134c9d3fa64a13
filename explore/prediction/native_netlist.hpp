#pragma once

#include "explore/netlist_run.hpp"
#include "netlist/network/network.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace placedpar {

/// Describes a native run of the network on so many threads (at most one for each node with processes), as a netlist
/// that can be simulated: the threads are cores with the costs in `calibration`, a file that print_calibration() has
/// made, and the searches cost what they cost there. Computations of other kinds take no time, as in a native run.
///
/// Throws UserError if the network cannot run natively, if the file cannot be read, or if it lacks a problem.
std::string native_netlist(const Network&, std::size_t threads, const std::filesystem::path& calibration);

struct ThreadsTime {
    std::size_t threads;
    Time time;
};
/// Returns the predicted times of native runs on 1, 2, 3, 4, 6, 8, 12, 16 and so on threads, as far as the network has
/// processors. An interruption leaves some out. Throws as native_netlist(), and what the processes throw.
std::vector<ThreadsTime> predict_threads(const Network&, const std::filesystem::path& calibration, std::uint64_t seed,
                                         const Interruption&);

/// Returns the problems that the processes of the network search, each once, as the netlist names them.
std::vector<std::string> problems_of(const Network&);

} // namespace placedpar
