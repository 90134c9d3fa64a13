#pragma once

#include "netlist/kinds/catalogue.hpp"
#include "netlist/network/network.hpp"
#include "netlist/run_report.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace placedpar {

class NativeTrace; // native/native_trace.hpp

struct NativeSettings {
    std::uint64_t seed = 1;
    std::size_t threads = 1; ///< at least 1
    /// Returns the load of each node, that is, the computing time of its processes, from which place_nodes() chooses
    /// threads. If this function is empty, nodes are placed without loads.
    std::function<std::vector<Time>()> loads = {};
    /// How many times as fast as the simulated processors the processes compute; 0: at the speed of this computer.
    double pace = 0;
    NativeTrace* trace = nullptr; ///< records the run for a trace; null: the run is not recorded
    /// Makes the process kinds for one thread. Called once for each thread.
    std::function<std::shared_ptr<const Catalogue>()> make_catalogue;
    /// Returns whether to end the run. Called about ten times a second.
    std::function<bool()> is_interrupted = [] { return false; };
};

/// Throws UserError if run_natively() cannot run the network.
void require_native(const Network&);

/// Runs the processes of a network in real time on threads of this computer, without simulating the machine. Wires,
/// switches and buses only show which processes communicate. The processes of a node, that is, a processor of the
/// netlist, run on one thread. In the report, the threads take the place of the processors.
///
/// Throws UserError if the network cannot run natively or a thread cannot be started. If a process fails, throws the
/// same exceptions as Machine::run.
RunReport run_natively(const Network&, const NativeSettings&);

} // namespace placedpar
