#pragma once

#include "identification/on_line/alarm.hpp"
#include "identification/on_line/excavator_parameters.hpp"
#include "identification/on_line/link_estimate.hpp"
#include "identification/on_line/moving_search.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace placedpar::identification {

/// Diagnoses an excavator on line whose configuration is recognised from its readings, as MovingSearch does. A link is
/// judged by cross-checks 1 and 2 of thesis 3.3, whenever a set that contains it has made a round of generations.
class MovingDiagnosis {
public:
    /// Number of samples that a set keeps. With fewer, the answers are less certain; with more, a fault is seen later,
    /// and a round takes longer.
    static constexpr std::size_t most_samples = 64;

    /// A link is judged after this number of rounds of the sets that contain it (our choice): in the first round, the
    /// readings of a single stretch decide.
    static constexpr std::size_t fewest_rounds = 2;
    /// The least change of a compliance that is a fault, relative to a healthy link and in standard errors (our
    /// choice).
    static constexpr double least_share = WayUnits::compliance_share, least_errors = 3;

    /// The method is made for samples 20 ms apart. Returns whether it also works with samples `period_s` apart: from
    /// .018 to .025 s (found by trying).
    static bool suits(double period_s) { return period_s >= 0.018 - 1e-9 && period_s <= 0.025 + 1e-9; }

    /// `period_s` is the time between samples. REQUIRES: suits(period_s). `name` is the name of the excavator, and part
    /// of the names of the random streams.
    MovingDiagnosis(const ExcavatorParameters& parameters, double period_s, std::uint64_t seed,
                    const std::string& name);

    MovingDiagnosisState state() const;
    /// Continues from a state. REQUIRES: the state of an object with the same arguments.
    void go_on_from(MovingDiagnosisState state);

    /// Takes the next sample, and returns the number of generations made.
    std::size_t take(const hydraulics::ValveReading& sample, double time_s);
    /// Forgets the last samples after a gap, but keeps estimates and populations.
    void restart();
    /// Records an impossible reading, and forgets the last samples, which may contain it.
    void note_impossible(hydraulics::Link link);

    hydraulics::Configuration configuration() const { return search_.configuration(); }
    /// Returns the links into which oil flowed at the last sample.
    hydraulics::LinkSet driven() const;
    /// Returns the estimates of the set; nullopt if its search has not made a round.
    std::optional<SetEstimates> estimates(hydraulics::LinkSet set) const;
    /// Returns the verdict on the link: sound, a changed compliance, impossible readings, not enough evidence (fewer
    /// than `fewest_rounds` rounds), or `cannot_tell` (the sets disagree, or the answer is uncertain or not confirmed
    /// by least squares).
    LinkVerdict verdict(hydraulics::Link link, double health_in3_per_psi) const;

private:
    const SetSearch& search_of(hydraulics::LinkSet set) const { return search_.searches().at(set); }
    void note_round(hydraulics::LinkSet set, double time_s);
    void combine();
    std::size_t rounds_with(hydraulics::Link) const;

    MovingSearch search_;
    std::map<hydraulics::LinkSet, std::vector<LinkEstimate>> estimates_;
    hydraulics::PerLink<std::optional<std::size_t>> impossible_{}; ///< as in MovingDiagnosisState
    std::vector<LinkIdentified> combined_;                         ///< combines the estimates of all sets
};

} // namespace placedpar::identification
