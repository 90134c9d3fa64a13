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
    double pace = 0;              ///< as in NativeSettings
    NativeTrace* trace = nullptr; ///< records the run in rank 0; null: the run is not recorded. REQUIRES: null in all
                                  ///< ranks or in none
    /// Returns the load of each node, for the placement of nodes (native/placement.hpp). If this function is empty,
    /// nodes are placed without loads.
    std::function<std::vector<Time>()> loads = {};
    /// Makes the catalogue of process kinds for this rank. `send_note`: sends bytes to rank 0 during the run; REQUIRES:
    /// called by a process.
    std::function<std::shared_ptr<const Catalogue>(std::function<void(MessageBytes)> send_note)> make_catalogue;
    /// Called in rank 0 with each note of another rank, in the order in which the other rank has sent them.
    std::function<void(std::span<const std::uint8_t>)> receive_note = [](std::span<const std::uint8_t>) {};
    /// Returns whether to end the run. Called about ten times a second.
    std::function<bool()> is_interrupted = [] { return false; };
};

/// Runs the processes of a network natively (native_run.hpp) on the ranks of mpirun. The processes of a node run on one
/// rank (native/placement.hpp). In the report, the ranks take the place of the processors.
///
/// Returns the report in rank 0, and nothing in the other ranks, which must then end silently. Throws in rank 0 alone:
/// UserError for a network that cannot run natively on this number of ranks, and the exception of a process, with the
/// number of its rank. REQUIRES: called in all ranks, with the same network and seed.
std::optional<RunReport> run_on_ranks(const Network&, const RankRunSettings&, Ranks&);

} // namespace placedpar
