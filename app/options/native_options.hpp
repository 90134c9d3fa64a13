#pragma once

#include "app/options.hpp"
#include "explore/netlist_run.hpp"
#include "netlist/run_report.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace placedpar {

class NativeTrace;    // native/native_trace.hpp
class Ranks;          // ranks/ranks.hpp
struct PageContent;   // observe/page/run_page.hpp
struct RecordedFiles; // app/recorders.hpp

/// The options of a command that can run a netlist natively, that is, on threads of this computer instead of simulated
/// transputers.
struct NativeOptions {
    bool is_native = false;
    std::size_t threads = 0; ///< 0: one for each core, but not more than the network can use
    double pace = 0;         ///< 0: processes compute at the speed of this computer
    std::string map;         ///< "modulo" or "balance"; "" means "modulo"
};

void add_native(Options&, NativeOptions&);

/// Declares --threads.
void add_threads(Options&, std::size_t& threads);

/// Throws UserError if an option for simulated runs is given for a native run, or an option for native runs for a
/// simulated run. `typed` has each option for simulated runs and whether it is given. If `predicts` is true, the run
/// predicts a native run, and --threads is allowed.
void refuse_with_native(const NativeOptions&, bool predicts, const std::vector<std::pair<bool, const char*>>& typed);

/// Runs the network natively, with the seed, observer, checkpoints and interruption of the settings. If `trace` is not
/// null, records the run in it. Throws as run_netlist does. REQUIRES: the settings have an interruption.
RunReport run_natively(const Network&, const NativeOptions&, const RunSettings&, NativeTrace* trace);

/// Writes the files that show the course of a native run. The files show threads or ranks instead of nodes. Throws
/// UserError if a file cannot be written.
void write_recorded(const RecordedFiles&, const NativeTrace&, const PageContent&);

/// Returns the ranks, the processes that mpirun started, on which a native run is made. Returns null if the run is made
/// in this process alone.
std::unique_ptr<Ranks> ranks_of(const NativeOptions&);

/// What a rank has loaded. All ranks must have loaded the same.
struct LoadedRun {
    const Network& network;
    std::string checkpoints; ///< digest of the checkpoints; "" without checkpoints
    bool is_recorded;        ///< whether to record the run for a timeline or a page
};

/// Loads the network in all ranks. If a rank has another network, checkpoint, seed or version, throws UserError in rank
/// 0. Rethrows exceptions of `load` in rank 0. After such an error, returns false in the other ranks, which must then
/// end silently. REQUIRES: called in all ranks.
bool load_in_all(Ranks&, const NativeOptions&, std::uint64_t seed, const std::function<LoadedRun()>& load);

/// Runs the network natively on the ranks. The observer and the checkpoints of rank 0 receive the events and the states
/// of all ranks. If `trace` is not null, rank 0 records the run in it. Returns nullopt in the other ranks, which must
/// then end silently. Throws only in rank 0, as run_netlist does. REQUIRES: called in all ranks, after load_in_all().
std::optional<RunReport> run_on_ranks(const Network&, const NativeOptions&, const RunSettings&, Ranks&,
                                      NativeTrace* trace);

} // namespace placedpar
