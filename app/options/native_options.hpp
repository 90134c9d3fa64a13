#pragma once

#include "app/options.hpp"
#include "explore/netlist_run.hpp"
#include "netlist/run_report.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace placedpar {

/// The options of a command that can run a netlist natively (native/native_run.hpp).
struct NativeOptions {
    bool is_native = false;
    std::size_t threads = 0; ///< 0: as many as the computer has cores, but not more than can have processes
    double pace = 0;         ///< 0: the processes compute as fast as they can
    std::string map;         ///< "modulo", "balance", or "", which is "modulo"
};

void add_native(Options&, NativeOptions&);

/// Throws UserError for an option that was typed although only simulated runs have it, and for an option of native runs
/// without --native.
void refuse_with_native(const NativeOptions&, const std::vector<std::pair<bool, const char*>>& typed);

/// Runs the network natively. `observer` may be null. Throws as run_netlist does.
RunReport run_natively(const Network&, const NativeOptions&, std::uint64_t seed, SearchObserver* observer,
                       Interruption&);

} // namespace placedpar
