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

/// Diagnoses an excavator on line whose configuration is recognised from its readings, as MovingSearch does. A link is
/// judged by cross-checks 1 and 2 of thesis 3.3, whenever a set that contains it has made a round of generations.
class MovingDiagnosis : public DiagnosisWay {
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

    std::optional<hydraulics::Configuration> configuration() const override { return search_.configuration(); }
    /// Returns the links into which oil flowed at the last sample.
    hydraulics::LinkSet active() const override;
    hydraulics::LinkSet read_links() const override { return hydraulics::LinkSet::all(); }
    std::size_t take(const NewestSample& newest) override;
    /// Forgets the last samples, but keeps estimates and populations.
    void restart(const hydraulics::PerLink<double>&) override { search_.restart(); }
    /// Records an impossible reading, and forgets the last samples, which may contain it.
    void note_impossible(hydraulics::Link link) override;
    std::optional<SetEstimates> estimates(hydraulics::LinkSet set) const override;
    /// Returns the verdict on the link: sound, a changed compliance, impossible readings, not enough evidence (fewer
    /// than `fewest_rounds` rounds), or `cannot_tell` (the sets disagree, or the answer is uncertain or not confirmed
    /// by least squares).
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
    std::vector<LinkIdentified> combined_;                         ///< combines the estimates of all sets
};

} // namespace placedpar::identification
