#pragma once

#include "identification/on_line/cross_check.hpp"
#include "identification/on_line/link_track.hpp"
#include "identification/on_line/population_set.hpp"
#include "identification/on_line/population_sets.hpp"
#include "monitor/protocol/message.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace placedpar::monitor {

/// What a sample led to.
struct SampleOutcome {
    std::size_t generations = 0;
    bool window_restarted = false; // a gap in time, or time began anew
    std::vector<Alarm> raised, cleared;
};

/// The diagnosis of one excavator: its population sets, what feeds them, and the alarms that hold. A function
/// of the settings, the seed, the name and the messages taken, in their order; of nothing else.
class Machine {
public:
    /// All that a restart needs.
    struct State {
        std::string name;
        MachineParameters parameters;
        std::optional<hydraulics::Configuration> configuration;
        hydraulics::LinkSet active;
        std::optional<double> time_s;  // of the last sample
        bool time_may_restart = false; // a control system has connected since the last sample
        std::uint64_t samples = 0;
        PerLink<LinkTrack> tracks;
        std::map<hydraulics::LinkSet, PopulationSet::State> sets; // those ever used
        PerLink<std::optional<double>> baseline_in3_per_psi;
        std::vector<Alarm> alarms; // that hold
    };

    Machine(std::string name, const MachineParameters& parameters, const DiagnosisSettings& settings,
            std::uint64_t seed);
    Machine(State state, const DiagnosisSettings& settings, std::uint64_t seed);

    /// A copy: the sets are gathered.
    State state() const;

    const std::string& name() const { return state_.name; }
    const MachineParameters& parameters() const { return state_.parameters; }
    std::optional<hydraulics::Configuration> configuration() const { return state_.configuration; }
    hydraulics::LinkSet active() const { return state_.active; }
    std::optional<double> time_s() const { return state_.time_s; }
    std::uint64_t samples() const { return state_.samples; }
    const std::map<hydraulics::LinkSet, PopulationSet>& sets() const { return sets_; }
    const std::vector<Alarm>& alarms() const { return state_.alarms; }
    std::vector<hydraulics::LinkSet> sets_in_use() const;
    LinkCheck check(hydraulics::Link link) const;

    /// A control system has connected: the time of its samples may begin anew.
    void connected() { state_.time_may_restart = true; }
    /// The same configuration with the same links again changes nothing; any other restarts the windows.
    void change(const ConfigurationChange& change);
    /// Gives the alarms that this raises or clears.
    SampleOutcome set_baseline(const BaselineMessage& message);
    /// Throws BadMessage, having changed nothing, when there is no configuration yet, a reading of an active link
    /// is missing, or the time does not move on.
    SampleOutcome take(const SampleMessage& message);

private:
    void require_acceptable(const SampleMessage& message) const;
    /// Since the last sample; none when there was none, or time has begun anew.
    std::optional<double> elapsed_s(double time_s) const;
    void restart_windows();
    std::size_t search(hydraulics::LinkSet set, double centre_s);
    const SetProblem& problem(hydraulics::LinkSet set);
    PopulationSet& population(hydraulics::LinkSet set);
    void settle_baselines();
    void update_alarms(SampleOutcome& outcome);

    DiagnosisSettings settings_;
    std::uint64_t seed_;
    State state_; // without its sets
    hydraulics::CentredLineFit fit_;
    std::map<hydraulics::LinkSet, PopulationSet> sets_;
    std::map<std::pair<hydraulics::Configuration, hydraulics::LinkSet>, SetProblem> problems_;
};

} // namespace placedpar::monitor
