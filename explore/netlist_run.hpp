#pragma once

#include "netlist/repeated_run.hpp"
#include "netlist/run_report.hpp"

#include <atomic>
#include <cstdint>
#include <optional>

namespace placedpar {

class ProblemRegistry; // gaprocs/problem_registry.hpp
class SearchObserver;  // gaprocs/search_observer.hpp

/// Asks runs to end early.
class Interruption {
public:
    /// Ends the run that is going on, and at once every run that begins later. May be called from a signal handler.
    void request() noexcept;
    bool requested() const noexcept { return requested_; }

private:
    friend class InterruptibleSimulation;

    std::atomic<bool> requested_{false};
    std::atomic<Simulation*> simulation_{nullptr}; ///< the simulation that is running, or null
};

/// How a network is run.
struct RunSettings {
    std::uint64_t seed = 1;
    Time until = Time::max();                  ///< the run ends there if it is not over before
    std::optional<std::uint64_t> shuffle = {}; ///< runs what is ready in an order drawn from it, another course
    TraceSink* trace = nullptr;                ///< none: no trace
    SearchObserver* observer = nullptr;        ///< none: the searches are not observed
    Interruption* interruption = nullptr;      ///< none: nothing ends the run early. Serves one run at a time
    RecordedRun* record = nullptr;             ///< none: the run is not recorded. REQUIRES: empty
};

/// Throws what the processes throw.
RunReport run_netlist(const Network&, const ProblemRegistry&, const RunSettings&);
/// As above, with the kinds of a catalogue, which already know their observer: the settings' observer is ignored.
RunReport run_netlist(const Network&, const Catalogue&, const RunSettings&);
/// The same run, where it takes the course of the recorded one: without the machine, several times as fast. Of an
/// interrupted one the report says only that it is. None where it does not, or could not. REQUIRES: the record is of
/// this network, and that is determinate; neither trace nor shuffle nor another record are asked for.
std::optional<RunReport> repeat_netlist(const Network&, const Catalogue&, const RecordedRun&, const RunSettings&);

} // namespace placedpar
