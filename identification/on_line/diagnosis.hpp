#pragma once

#include "hydraulics/circuit/line_fit.hpp"
#include "identification/on_line/alarm.hpp"
#include "identification/on_line/cross_check.hpp"
#include "identification/on_line/excavator_parameters.hpp"
#include "identification/on_line/frozen_watch.hpp"
#include "identification/on_line/inputs.hpp"
#include "identification/on_line/link_track.hpp"
#include "identification/on_line/population_set.hpp"
#include "identification/on_line/population_sets.hpp"
#include "identification/on_line/set_watch.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace placedpar::identification {

/// By how much the links of a set are off, by one movement alone, in the order of links_of().
struct JudgedMovement {
    hydraulics::LinkSet set;
    std::vector<Deviation> links; ///< from the links' compliances in health, no leak, no offset
};

/// The readings of the sample that is not whole yet.
struct OpenSample {
    std::size_t readings = 0;
    double first_s = 0; ///< when the first was read
    double after_s = 0; ///< by how much later all were, in sum

    double middle_s() const { return first_s + after_s / static_cast<double>(readings); }
    friend bool operator==(const OpenSample&, const OpenSample&) = default;
};

/// Holds all that a restart of a Diagnosis needs.
struct DiagnosisState {
    std::string name; ///< the excavator's
    ExcavatorParameters parameters;
    std::optional<hydraulics::Configuration> configuration;
    hydraulics::LinkSet active;
    std::optional<double> time_s;  ///< of the last reading
    bool time_may_restart = false; ///< a control system has connected since the last sample
    std::uint64_t samples = 0;     ///< read
    OpenSample open;
    std::optional<double> sample_s; ///< the middle of the last whole sample since the windows began
    hydraulics::PerLink<LinkTrack> tracks;
    std::map<hydraulics::LinkSet, PopulationSet::State> sets; ///< those ever used
    hydraulics::PerLink<double> health_in3_per_psi{}; ///< compliances, of its kind unless the control system told
    hydraulics::PerLink<FrozenWatch> pressures, angles;
    std::map<hydraulics::LinkSet, SetWatch::State> watches; ///< of the sets ever used
    bool judged = false;                                    ///< something, since the alarms were found last
    std::vector<Alarm> alarms;                              ///< that hold

    friend bool operator==(const DiagnosisState&, const DiagnosisState&) = default;
};

/// What a reading led to.
struct SampleOutcome {
    std::size_t generations = 0;
    bool window_restarted = false;      ///< after a gap in time, or because time began anew
    std::vector<JudgedMovement> judged; ///< that are over with it
    std::vector<Alarm> raised, cleared;
};

/// The on-line diagnosis of one excavator: its population sets, what feeds them, and the alarms that hold. Readings of
/// a quick logger are averaged to the samples that all of it is made for (hydraulics/data/sampling.hpp); only sensors
/// that freeze and readings that are impossible are looked for before that.
///
/// 1. Its state is a function of settings, seed, name and the inputs taken, in their order; of nothing else.
/// 2. An input that is refused changes nothing.
class Diagnosis {
public:
    using State = DiagnosisState;

    Diagnosis(std::string name, const ExcavatorParameters& parameters, const DiagnosisSettings& settings,
              std::uint64_t seed);
    Diagnosis(State state, const DiagnosisSettings& settings, std::uint64_t seed);

    /// A copy, with the states of the sets in it.
    State state() const;

    const std::string& name() const { return state_.name; }
    const ExcavatorParameters& parameters() const { return state_.parameters; }
    std::optional<hydraulics::Configuration> configuration() const { return state_.configuration; }
    hydraulics::LinkSet active() const { return state_.active; }
    std::optional<double> time_s() const { return state_.time_s; }
    std::uint64_t samples() const { return state_.samples; } ///< that were read
    const hydraulics::Sampling& sampling() const { return sampling_; }
    /// The middle of the last whole sample since the windows began.
    std::optional<double> sample_s() const { return state_.sample_s; }
    const std::map<hydraulics::LinkSet, PopulationSet>& sets() const { return sets_; }
    /// The compliance of the link in health, of its kind unless the control system told.
    double health_in3_per_psi(hydraulics::Link link) const {
        return state_.health_in3_per_psi[hydraulics::index_of(link)];
    }
    const std::vector<Alarm>& alarms() const { return state_.alarms; }
    std::vector<hydraulics::LinkSet> sets_in_use() const;
    LinkCheck check(hydraulics::Link link) const;
    /// By the set that says most: a fault before none, then the one that has judged most movements.
    LinkVerdict verdict(hydraulics::Link link) const;
    /// The compliance that the link is compared with: its own over its first movements, or that of its kind.
    double baseline_in3_per_psi(hydraulics::Link link) const;

    /// A control system has connected: the time of its samples may begin anew.
    void connected() { state_.time_may_restart = true; }
    /// The same configuration with the same links again changes nothing; any other restarts the windows.
    void change(const ConfigurationChange& change);
    /// The links' compliances in health; they are judged anew. Gives the alarms that this raises or clears.
    SampleOutcome set_baseline(const Baseline& baseline);
    /// What is read at one instant. Throws RefusedSample when there is no configuration yet, a reading of an active
    /// link is missing, or the sample is not later than the last one.
    SampleOutcome take(const ExcavatorSample& sample);
    /// No sample follows this one for a while: judges what there is of movements.
    SampleOutcome end_movements();
    /// The movement that the set is in, or none.
    const Movement::State* movement(hydraulics::LinkSet set) const;

private:
    void require_acceptable(const ExcavatorSample& sample) const;
    /// Since the last sample; none when there was none, or time has begun anew.
    std::optional<double> elapsed_s(double time_s) const;
    bool follows(std::optional<double> elapsed_s) const;
    void read(const ExcavatorSample& sample, std::optional<double> elapsed_s);
    /// Is a sample whole with this reading, and the next of the windows?
    bool finish_sample(SampleOutcome& outcome);
    void restart_windows();
    std::size_t search(hydraulics::LinkSet set, const ExcavatorSample& sample, double centre_s);
    void watch(hydraulics::LinkSet set, const SetSample& centre, const ExcavatorSample& newest);
    void end_movement(hydraulics::LinkSet set);
    void watch_readings(const ExcavatorSample& sample);
    /// Of the link, what no machine gives.
    void note_impossible(hydraulics::LinkSet set, hydraulics::Link link);
    std::vector<double> health_in3_per_psi(hydraulics::LinkSet set) const;
    void note(hydraulics::LinkSet set, SetWatch::Judged judged);
    SetWatch::State& watch_of(hydraulics::LinkSet set);
    const SetProblem& problem(hydraulics::LinkSet set);
    PopulationSet& population(hydraulics::LinkSet set);
    void judge(SampleOutcome& outcome);
    void update_alarms(SampleOutcome& outcome);

    DiagnosisSettings settings_;
    std::uint64_t seed_;
    hydraulics::Sampling sampling_;
    State state_;                        ///< without its sets
    std::vector<JudgedMovement> judged_; ///< since the last outcome
    hydraulics::CentredLineFit fit_;
    std::map<hydraulics::LinkSet, PopulationSet> sets_;
    std::map<std::pair<hydraulics::Configuration, hydraulics::LinkSet>, SetProblem> problems_;
};

} // namespace placedpar::identification
