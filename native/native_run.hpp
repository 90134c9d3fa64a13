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
    /// Returns the load of each node, by which nodes are placed (native/placement.hpp). Empty: without loads.
    std::function<std::vector<Time>()> loads = {};
    /// How much faster than the simulated processors the processes compute; 0: as fast as they can (native/pace.hpp).
    double pace = 0;
    NativeTrace* trace = nullptr; ///< records the run; null: the run is not recorded
    /// Makes the kinds of the processes of one thread. Called once for each thread.
    std::function<std::shared_ptr<const Catalogue>()> make_catalogue;
    /// Called about ten times a second; the run ends if it returns true.
    std::function<bool()> is_interrupted = [] { return false; };
};

/// Throws UserError for a network that cannot run natively.
void require_native(const Network&);

/// Runs the processes of a network on threads of this computer. Time is that of the wall clock, and a computation takes
/// the time that it takes. Wires, switches and buses only show which processes communicate. The processes of a node run
/// on one thread (native/placement.hpp). In the report, the threads stand in place of the processors.
///
/// Throws UserError for a network that cannot run natively, if a thread cannot be started, and what Machine::run throws
/// for a process that fails.
RunReport run_natively(const Network&, const NativeSettings&);

} // namespace placedpar
