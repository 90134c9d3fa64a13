#pragma once

#include "identification/on_line/diagnosis_way.hpp"
#include "identification/on_line/moving_search.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace placedpar::identification {

/// Diagnoses a working excavator that does not report the configuration of its main valve. A MovingSearch recognises
/// the configuration from the readings, and searches the compliances of each set of links that share oil. After each
/// round of generations of a set, its links are judged by cross-checks 1 and 2 of thesis 3.3. Compliances of one link
/// from different sets must agree. If all links that one pump feeds have the same fault, the fault is in a part that
/// they share.
class MovingDiagnosis : public DiagnosisWay {
public:
    /// The number of samples that the search of a set keeps. With fewer samples the answers are less certain. With more
    /// samples a fault is found later, and a round takes longer.
    static constexpr std::size_t most_samples = 64;

    /// A link is judged after this number of rounds of the sets that contain it. After the first round alone, the
    /// readings of a single movement would decide.
    static constexpr std::size_t fewest_rounds = 2;
    /// A changed compliance is a fault if the change is at least this share of the healthy compliance and this number
    /// of standard errors.
    static constexpr double least_share = WayUnits::compliance_share, least_errors = 3;

    /// Returns whether the recognition of configurations works with samples `period_s` apart. It is made for 20 ms;
    /// trials show that it works from 0.018 to 0.025 s.
    static bool suits(double period_s) { return period_s >= 0.018 - 1e-9 && period_s <= 0.025 + 1e-9; }

    /// `period_s` is the time between samples. REQUIRES: suits(period_s). `name` is the name of the excavator, and part
    /// of the names of the random streams.
    MovingDiagnosis(const ExcavatorParameters& parameters, double period_s, std::uint64_t seed,
                    const std::string& name);

    MovingDiagnosisState state() const;
    /// Continues from a saved state. REQUIRES: the state is of an object that was constructed with the same arguments.
    void go_on_from(MovingDiagnosisState state);

    std::optional<hydraulics::Configuration> configuration() const override { return search_.configuration(); }
    /// Returns the links into which oil flowed at the last sample.
    hydraulics::LinkSet active() const override;
    hydraulics::LinkSet read_links() const override { return hydraulics::LinkSet::all(); }
    std::size_t take(const NewestSample& newest) override;
    /// Forgets the last samples after a gap, but keeps estimates and populations.
    void restart(const hydraulics::PerLink<double>&) override { search_.restart(); }
    /// Records an impossible reading of the link, and forgets the last samples, because they may contain the reading.
    void note_impossible(hydraulics::Link link) override;
    std::optional<SetEstimates> estimates(hydraulics::LinkSet set) const override;
    /// Returns the verdict on the link: sound, a changed compliance, or impossible readings. With fewer than
    /// `fewest_rounds` rounds the verdict is `not_enough_evidence`. If the sets disagree, or if the compliance is
    /// uncertain or least squares does not confirm it, the verdict is `cannot_tell`.
    LinkVerdict verdict(hydraulics::Link link, double health_in3_per_psi) const override;
    /// Returns the healthy compliance: no link has a baseline of its own.
    double baseline_in3_per_psi(hydraulics::Link, double health_in3_per_psi) const override {
        return health_in3_per_psi;
    }
    /// An alarm stays until the link is found sound, or has another fault.
    bool keeps_alarm(VerdictKind kind) const override {
        return kind == VerdictKind::not_enough_evidence || kind == VerdictKind::cannot_tell;
    }

private:
    const SetSearch& search_of(hydraulics::LinkSet set) const { return search_.searches().at(set); }
    void note_round(hydraulics::LinkSet set, double time_s);
    void combine();
    std::size_t rounds_with(hydraulics::Link) const;

    hydraulics::PerLink<hydraulics::LinkConstants> links_;
    MovingSearch search_;
    std::map<hydraulics::LinkSet, std::vector<LinkEstimate>> estimates_;
    hydraulics::PerLink<std::optional<std::size_t>> impossible_{}; ///< as in MovingDiagnosisState
    std::vector<LinkIdentified> combined_; ///< the combined estimates of all sets, one for each link
};

} // namespace placedpar::identification
