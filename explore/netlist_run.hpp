#pragma once

#include "netlist/repeated_run.hpp"
#include "netlist/run_report.hpp"

#include <atomic>
#include <cstdint>
#include <optional>

namespace placedpar {

class ProblemRegistry; // gaprocs/problem_registry.hpp
class SearchObserver;  // gaprocs/search_observer.hpp
class Checkpoints;     // gaprocs/checkpoints.hpp

/// Asks runs to end early.
class Interruption {
public:
    /// Ends the current run, and ends each later run at its beginning. May be called from a signal handler.
    void request() noexcept;
    bool requested() const noexcept { return requested_; }

private:
    friend class InterruptibleSimulation;

    std::atomic<bool> requested_{false};
    std::atomic<Simulation*> simulation_{nullptr}; ///< the simulation that is running, or null
};

struct RunSettings {
    std::uint64_t seed = 1;
    Time until = Time::max();                  ///< latest end of the run
    std::optional<std::uint64_t> shuffle = {}; ///< seed of a random order of the ready processes; empty: usual order
    TraceSink* trace = nullptr;                ///< null: no trace
    SearchObserver* observer = nullptr;        ///< null: the searches are not observed
    Checkpoints* checkpoints = nullptr;        ///< null: the searches begin anew, and their states are not kept
    /// Null: nothing ends the run early. An interruption can end only one run at a time.
    Interruption* interruption = nullptr;
    RecordedRun* record = nullptr; ///< null: the run is not recorded. REQUIRES: the record is empty
};

/// Runs the network. Rethrows the exceptions of the processes.
RunReport run_netlist(const Network&, const ProblemRegistry&, const RunSettings&);
/// Runs the network with the process kinds of a catalogue (netlist/kinds/catalogue.hpp). The kinds already have an
/// observer and checkpoints, so the observer and the checkpoints in the settings are ignored.
RunReport run_netlist(const Network&, const Catalogue&, const RunSettings&);
/// Repeats a recorded run with another seed, without simulating the machine; this is several times faster. Returns
/// nothing if a process behaves differently with this seed, or if the run would not complete. If the run is
/// interrupted, the report says only that it was interrupted. REQUIRES: the record is of this network; the network is
/// determinate; the settings have no trace, shuffle or record.
std::optional<RunReport> repeat_netlist(const Network&, const Catalogue&, const RecordedRun&, const RunSettings&);

} // namespace placedpar
