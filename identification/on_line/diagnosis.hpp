#pragma once

#include "hydraulics/circuit/line_fit.hpp"
#include "hydraulics/data/sampling.hpp"
#include "identification/on_line/cross_check.hpp"
#include "identification/on_line/diagnosis_way.hpp"
#include "identification/on_line/population_set.hpp"
#include "identification/on_line/population_sets.hpp"
#include "identification/verdict/movement.hpp"

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace placedpar::identification {

class MovingDiagnosis; // identification/on_line/moving_diagnosis.hpp
struct DiagnosisState; // identification/on_line/diagnosis_state.hpp

/// The effects of one reading.
struct SampleOutcome {
    std::size_t generations = 0;
    bool window_restarted = false;      ///< whether the windows restarted, after a gap in time or a restart of time
    std::vector<JudgedMovement> judged; ///< movements that ended with this reading
    std::vector<Alarm> raised, cleared;
};

/// The on-line diagnosis of one excavator: the data of its links, one of two ways to judge them, and the active alarms.
/// ReportedDiagnosis judges the links until the recognition of the configuration begins, and again after the
/// recognition has ended. It then continues with its earlier findings. In between, MovingDiagnosis judges the links.
/// The readings of a fast logger are first averaged to samples about 20 ms apart (hydraulics/data/sampling.hpp). Single
/// readings are used only by the checks for frozen sensors and for pressures below vacuum, and to compute a spool's
/// position from its voltage.
///
/// 1. The state is a function of settings, seed, name, parameters and the accepted inputs in their order, and of
/// nothing else.
/// 2. A refused input changes nothing.
class Diagnosis {
public:
    using State = DiagnosisState;

    Diagnosis(std::string name, const ExcavatorParameters& parameters, const DiagnosisSettings& settings,
              std::uint64_t seed);
    Diagnosis(State state, const DiagnosisSettings& settings, std::uint64_t seed);
    Diagnosis(const Diagnosis&);
    Diagnosis(Diagnosis&&) noexcept;
    Diagnosis& operator=(const Diagnosis&);
    Diagnosis& operator=(Diagnosis&&) noexcept;
    ~Diagnosis();

    /// Returns a copy of the state, with the states of both ways.
    State state() const;

    const std::string& name() const;
    const ExcavatorParameters& parameters() const;
    /// Returns whether the configuration is recognised from the readings.
    bool recognises() const;
    /// Returns the configuration, as reported or as recognised at the last sample.
    std::optional<hydraulics::Configuration> configuration() const;
    /// Returns the active links, as reported or as recognised at the last sample.
    hydraulics::LinkSet active() const;
    std::optional<double> time_s() const;
    std::uint64_t samples() const; ///< number of instants read
    const hydraulics::Sampling& sampling() const { return sampling_; }
    /// Returns the mean time of the last complete sample; nullopt after the windows have restarted.
    std::optional<double> sample_s() const;
    /// Returns the state of the link two samples before sample_s(); nullopt if the windows have restarted since.
    std::optional<hydraulics::LinkSample> centre(hydraulics::Link link) const;
    /// Returns the population sets that were searched in reported configurations.
    const std::map<hydraulics::LinkSet, PopulationSet>& sets() const;
    /// Returns the estimates of the set; nullopt if it has not been used.
    std::optional<SetEstimates> estimates(hydraulics::LinkSet set) const;
    /// Returns the estimates of all sets ever used, in the order of Figure 3.13. While the configuration is recognised,
    /// these are the sets that have been searched in this time.
    std::vector<SetEstimates> estimates() const;
    /// Returns the compliance of the healthy link: the value that the control system has set, or else the value for the
    /// machine's kind.
    double health_in3_per_psi(hydraulics::Link link) const;
    const std::vector<Alarm>& alarms() const;
    std::vector<hydraulics::LinkSet> sets_in_use() const;
    LinkCheck check(hydraulics::Link link) const;
    /// Returns one of the verdicts that the sets give on the link: a verdict that states a fault, if there is one, and
    /// among several verdicts the verdict from the most movements.
    LinkVerdict verdict(hydraulics::Link link) const;
    /// Returns the compliance with which the link is compared: the value from the link's first movements, or else
    /// health_in3_per_psi(). While the configuration is recognised, it is always health_in3_per_psi().
    double baseline_in3_per_psi(hydraulics::Link link) const;

    /// Records that a control system has connected, so the time of its samples may restart.
    void connected();
    /// Changes configuration and active links. Does nothing if both are unchanged; otherwise the windows restart. Ends
    /// the recognition of the configuration and forgets what was found by it, with its alarms. Returns the alarms
    /// raised or cleared.
    SampleOutcome change(const ConfigurationChange& change);
    /// Returns whether configurations can be recognised at the rate of the readings (MovingDiagnosis::suits()).
    bool can_recognise() const;
    /// Begins to recognise configuration and active links from the readings (MovingDiagnosis). Each sample must then
    /// have the readings of all links. Active alarms stay until the links are judged. Does nothing if the recognition
    /// has already begun. REQUIRES: can_recognise().
    SampleOutcome change(const RecognisedConfiguration&);
    /// Sets compliances of healthy links and forgets the judgements of these links by movements. Returns the alarms
    /// raised or cleared.
    SampleOutcome set_baseline(const Baseline& baseline);
    /// Processes the readings of one instant. Throws RefusedSample if there is no configuration yet, or if a reading of
    /// an active link is missing. Also throws it if the sample is not later than the last sample, unless connected()
    /// has been called since.
    SampleOutcome take(const ExcavatorSample& sample);
    /// Ends and judges all movements. Call this function when no sample will follow for a while. While the
    /// configuration is recognised, this function only restarts the windows.
    SampleOutcome end_movements();
    /// Returns the set's movement in progress; null if there is none.
    const Movement::State* movement(hydraulics::LinkSet set) const;

private:
    struct Parts; ///< the state and the two ways

    MovingDiagnosis& begin_moving();
    const DiagnosisWay& way() const;
    DiagnosisWay& way();
    void require_acceptable(const ExcavatorSample& sample) const;
    /// Returns the time since the last sample; nullopt if there was none or time has restarted.
    std::optional<double> elapsed_s(double time_s) const;
    bool follows(std::optional<double> elapsed_s) const;
    void read(const ExcavatorSample& sample, std::optional<double> elapsed_s);
    /// Returns whether this reading completes a sample that continues the windows.
    bool finish_sample(SampleOutcome& outcome);
    void restart_windows();
    void watch_readings(const ExcavatorSample& sample);
    bool is_impossible(hydraulics::Link link, const Reading& reading);
    void judge(SampleOutcome& outcome);
    void update_alarms(SampleOutcome& outcome);
    bool stays(const Alarm& alarm) const;

    DiagnosisSettings settings_;
    std::uint64_t seed_;
    hydraulics::Sampling sampling_;
    hydraulics::CentredLineFit fit_;
    std::unique_ptr<Parts> parts_;
};

} // namespace placedpar::identification
