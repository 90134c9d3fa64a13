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

struct NativeSettings {
    std::uint64_t seed = 1;
    std::size_t threads = 1; ///< at least 1
    /// Makes the kinds of the processes of one thread. Called once for each thread.
    std::function<std::shared_ptr<const Catalogue>()> make_catalogue;
    /// Called about ten times a second; the run ends if it returns true.
    std::function<bool()> is_interrupted = [] { return false; };
};

/// Returns the number of nodes that have processes. A run can use as many threads.
std::size_t count_native_nodes(const Network&);

/// Returns the thread of each node in a native run on so many threads. Throws UserError for a network that cannot run
/// natively. REQUIRES: threads >= 1.
std::vector<std::size_t> threads_of_nodes(const Network&, std::size_t threads);

/// Runs the processes of a network on threads of this computer. Time is that of the wall clock, and a computation takes
/// the time that it takes. Wires, switches and buses only show which processes communicate. The processes of node i of
/// those that have processes run on thread i modulo the number of threads. In the report, the threads stand in place of
/// the processors.
///
/// Throws UserError for a network that cannot run natively, and what Machine::run throws for a process that fails.
RunReport run_natively(const Network&, const NativeSettings&);

} // namespace placedpar
