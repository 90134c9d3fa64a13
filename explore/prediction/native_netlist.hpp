#pragma once

#include "explore/netlist_run.hpp"
#include "netlist/network/network.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace placedpar {

/// The threads of this computer, or the ranks of mpirun, on which a native run is predicted.
struct PredictedPlaces {
    enum class Kind { threads, ranks };
    Kind kind = Kind::threads;
    std::size_t count = 1; ///< at least 1
};

/// Describes a native run of the network on these places, as a netlist whose simulation predicts the time of the run. A
/// native run executes the processes on this computer, without simulating the machine. The places become cores. Their
/// costs and the costs of the searches come from `calibration`, a file that print_calibration() has made. Computations
/// of processes that do not search take no time, because a native run does not wait for the simulated cycles. There are
/// at most as many threads as nodes with processes.
///
/// Throws UserError if the network cannot run natively on these places, if the file cannot be read, or if the file
/// lacks the costs of ranks or of a problem.
std::string native_netlist(const Network&, const PredictedPlaces&, const std::filesystem::path& calibration);

/// Returns whether the file has the costs of places of this kind. Throws as native_netlist() does.
bool describes(PredictedPlaces::Kind, const std::filesystem::path& calibration);

struct PredictedTime {
    std::size_t places;
    Time time;
};
/// Returns the predicted times of native runs on 1, 2, 3, 4, 6, 8, 12, 16 and so on threads or ranks, up to the number
/// of the network's processors. After an interruption, the list is incomplete. Throws as native_netlist() does, and
/// what the processes throw.
std::vector<PredictedTime> predict_times(const Network&, PredictedPlaces::Kind,
                                         const std::filesystem::path& calibration, std::uint64_t seed,
                                         const Interruption&);

/// Returns the problems that the processes of the network search, each once, as the netlist names them.
std::vector<std::string> problems_of(const Network&);

} // namespace placedpar
