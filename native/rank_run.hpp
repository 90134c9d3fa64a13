#pragma once

#include "netlist/kinds/catalogue.hpp"
#include "netlist/network/network.hpp"
#include "netlist/run_report.hpp"
#include "runtime/byte_form.hpp"
#include "runtime/time.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace placedpar {

class NativeTrace; // native/native_trace.hpp
class Ranks;       // ranks/ranks.hpp

struct RankRunSettings {
    std::uint64_t seed = 1;
    double pace = 0;              ///< how many times as fast as the simulated processors the processes compute; 0: at
                                  ///< the speed of this computer
    NativeTrace* trace = nullptr; ///< records the run in rank 0, for a trace; null: the run is not recorded. REQUIRES:
                                  ///< null in all ranks or in none
    /// Returns the load of each node, that is, the computing time of its processes, from which place_nodes() chooses
    /// ranks. If this function is empty, nodes are placed without loads.
    std::function<std::vector<Time>()> loads = {};
    /// Makes the process kinds for this rank. Their processes may call `send_note` to send bytes to rank 0 during the
    /// run.
    std::function<std::shared_ptr<const Catalogue>(std::function<void(MessageBytes)> send_note)> make_catalogue;
    /// Called in rank 0 with each note of another rank, in the order in which the other rank has sent them.
    std::function<void(std::span<const std::uint8_t>)> receive_note = [](std::span<const std::uint8_t>) {};
    /// Returns whether to end the run. Called about ten times a second.
    std::function<bool()> is_interrupted = [] { return false; };
};

/// Runs the processes of a network in real time on the ranks of mpirun, that is, on copies of this program. The
/// processes of a node, that is, a processor of the netlist, run on one rank. In the report, the ranks take the place
/// of the processors.
///
/// Returns the report in rank 0, and nothing in the other ranks, which must then end silently. Only rank 0 throws:
/// UserError if the network cannot run in this way, and the exception of a process, with the number of its rank.
/// REQUIRES: called in all ranks, with the same network and seed.
std::optional<RunReport> run_on_ranks(const Network&, const RankRunSettings&, Ranks&);

} // namespace placedpar
