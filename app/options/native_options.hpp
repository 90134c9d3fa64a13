#pragma once

#include "app/options.hpp"
#include "explore/netlist_run.hpp"
#include "netlist/run_report.hpp"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace placedpar {

/// The options of a command that can run a netlist natively (native/native_run.hpp).
struct NativeOptions {
    bool is_native = false;
    std::size_t threads = 0; ///< 0: as many as the computer has cores, but not more than nodes with processes
};

void add_native(Options&, NativeOptions&);

/// Declares --threads.
void add_threads(Options&, std::size_t& threads);

/// Throws UserError for an option that was typed although only simulated runs have it, and for --threads if the run
/// is neither native nor the prediction of a native run.
void refuse_with_native(const NativeOptions&, bool predicts, const std::vector<std::pair<bool, const char*>>& typed);

/// Runs the network natively. `observer` may be null. Throws as run_netlist does.
RunReport run_natively(const Network&, const NativeOptions&, std::uint64_t seed, SearchObserver* observer,
                       const Interruption&);

} // namespace placedpar
