#pragma once

#include "app/options.hpp"
#include "explore/netlist_run.hpp"
#include "netlist/run_report.hpp"

#include <cstddef>
#include <utility>
#include <vector>

namespace placedpar {

/// The options of a command that can run a netlist natively (native/native_run.hpp).
struct NativeOptions {
    bool is_native = false;
    std::size_t threads = 0; ///< 0: as many as the computer has cores, but not more than nodes with processes
};

void add_native(Options&, NativeOptions&);

/// Throws UserError for an option that was typed although only simulated runs have it, and for --threads without
/// --native.
void refuse_with_native(const NativeOptions&, const std::vector<std::pair<bool, const char*>>& typed);

/// Runs the network natively, with the seed, observer, checkpoints and interruption of the settings. Throws as
/// run_netlist does. REQUIRES: there is an interruption.
RunReport run_natively(const Network&, const NativeOptions&, const RunSettings&);

} // namespace placedpar
