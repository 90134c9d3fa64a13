#pragma once

#include "hydraulics/circuit/circuit.hpp"
#include "identification/on_line/alarm.hpp"
#include "identification/on_line/inputs.hpp"
#include "identification/on_line/link_estimate.hpp"
#include "identification/on_line/link_track.hpp"

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace placedpar::identification {

/// The deviations of the links of a population set (population_sets.hpp) in one movement, in the order of links_of().
struct JudgedMovement {
    hydraulics::LinkSet set;
    /// Deviations from a healthy link, which has the healthy compliance, no leak and no offset.
    std::vector<Deviation> links;
};

/// What a diagnosis has judged since the alarms were last determined.
struct Judgements {
    bool changed = false; ///< whether a verdict may have changed
    std::vector<JudgedMovement> movements;
};

/// The newest sample of the links that are read.
struct NewestSample {
    const hydraulics::PerLink<LinkTrack>& tracks; ///< the last samples of each link
    const ExcavatorSample& reading;               ///< the reading that completed the sample
    double time_s;
    const hydraulics::PerLink<double>& health_in3_per_psi; ///< compliances of healthy links
};

/// A way to judge the links. There are two: the control system reports the configuration (ReportedDiagnosis), or it is
/// recognised (MovingDiagnosis).
class DiagnosisWay {
public:
    virtual ~DiagnosisWay() = default;

    /// Returns the present configuration; nullopt if there is none yet.
    virtual std::optional<hydraulics::Configuration> configuration() const = 0;
    /// Returns the links into which oil flows.
    virtual hydraulics::LinkSet active() const = 0;
    /// Returns the links whose readings are used.
    virtual hydraulics::LinkSet read_links() const = 0;

    /// Takes the next sample, and returns the number of generations made.
    virtual std::size_t take(const NewestSample&) = 0;
    /// Forgets the last samples after a gap or before a change of configuration.
    virtual void restart(const hydraulics::PerLink<double>& health_in3_per_psi) = 0;
    virtual void note_impossible(hydraulics::Link) = 0;

    /// Returns the estimates of the set; nullopt if it has none.
    virtual std::optional<SetEstimates> estimates(hydraulics::LinkSet) const = 0;
    virtual LinkVerdict verdict(hydraulics::Link, double health_in3_per_psi) const = 0;
    /// Returns the compliance with which the link is compared.
    virtual double baseline_in3_per_psi(hydraulics::Link, double health_in3_per_psi) const = 0;
    /// Returns whether an alarm stays, although the link's present verdict does not raise it.
    virtual bool keeps_alarm(VerdictKind) const = 0;

    const Judgements& judgements() const { return judgements_; }
    /// Returns the judgements, which then begin anew.
    Judgements take_judgements() { return std::exchange(judgements_, {}); }

protected:
    DiagnosisWay() = default;
    DiagnosisWay(const DiagnosisWay&) = default;
    DiagnosisWay(DiagnosisWay&&) = default;
    DiagnosisWay& operator=(const DiagnosisWay&) = default;
    DiagnosisWay& operator=(DiagnosisWay&&) = default;

    Judgements judgements_;
};

} // namespace placedpar::identification
