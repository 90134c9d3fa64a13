#include "identification/on_line/record_diagnosis.hpp"

#include "hydraulics/circuit/line_fit.hpp"

#include <algorithm>

namespace placedpar::identification {

using namespace hydraulics;

namespace {

LinkFinding finding_of(Link link, const LinkEstimate& estimate, double since_s, const DiagnosisSettings& settings) {
    const LinkEstimate::State& state = estimate.state();
    if (!estimate.compliance_in3_per_psi() || state.time_s < since_s)
        return {link,
                std::nullopt,
                0,
                {},
                {{FlagKind::no_excitation, "no excitation: the pressure hardly changes, so noise would determine "
                                           "the answer"}}};
    const bool settled = estimate.settled_in3_per_psi() && state.settled_time_s >= since_s;
    return {link, settled ? estimate.settled_in3_per_psi() : estimate.compliance_in3_per_psi(),
            settled ? state.settled_error_in3_per_psi : state.standard_error_in3_per_psi, estimate.spread_in3_per_psi(),
            settled ? estimate.settled_flags(settings) : estimate.flags(settings)};
}

WholeMovement whole_movement(const Deviation& deviation, double health_in3_per_psi) {
    const WayUnits units = WayUnits::of(health_in3_per_psi);
    return {deviation, units, health_in3_per_psi + units.compliance_in3_per_psi * deviation.by[0]};
}

/// Compares the estimate with the least-squares fit to the whole movement, since a search for several compliances can
/// settle on a wrong string.
void confirm(LinkFinding& link, std::size_t links) {
    if (!link.compliance_in3_per_psi || !link.whole)
        return;
    const LeastSquares reference{link.whole->compliance_in3_per_psi,
                                 link.whole->units.compliance_in3_per_psi *
                                     link.whole->deviation.standard_error(FaultHypothesis::compliance)};
    if (auto flag = unconfirmed_flag(*link.compliance_in3_per_psi, reference, "the whole movement"))
        link.flags.push_back({flag->kind, flag->text + (links > 2 ? "; try --way whole" : "")});
}

/// Flags a link whose movement shows either a leak or an offset but does not distinguish them. If the areas are
/// measured directly, the link has no offset.
void note_leak_or_offset(LinkFinding& link) {
    constexpr double errors = 3;
    if (!link.whole || link.whole->deviation.by[index_of(FaultHypothesis::offset)] == 0)
        return;
    const Deviation& deviation = link.whole->deviation;
    const FaultSize leak = size_alone(FaultHypothesis::leak, deviation);
    if (leak.by > errors * leak.standard_error &&
        verdict_of(deviation, true, AreasFrom::spool).kind == VerdictKind::leak_or_offset)
        link.flags.push_back({FlagKind::leak_or_offset, print_leak_or_offset(deviation, link.whole->units)});
}

} // namespace

std::vector<MovementFinding> RecordDiagnosis::take(const Record& piece) {
    std::vector<MovementFinding> found;
    for (std::size_t i = 0; i < piece.size(); ++i) {
        const SampleOutcome outcome = diagnosis_.take(sample_of(piece, i, diagnosis_.active(), readers_));
        follow(outcome, found);
    }
    return found;
}

std::vector<MovementFinding> RecordDiagnosis::end() {
    std::vector<MovementFinding> found;
    const SampleOutcome outcome = diagnosis_.end_movements();
    follow(outcome, found);
    return found;
}

void RecordDiagnosis::follow(const SampleOutcome& outcome, std::vector<MovementFinding>& found) {
    const double period_s = diagnosis_.sampling().period_s();
    const double centre_s = diagnosis_.sample_s().value_or(0) - static_cast<double>(line_fit_points / 2) * period_s;
    for (LinkSet set : diagnosis_.sets_in_use()) {
        Progress& progress = progress_[set];
        const Movement::State* movement = diagnosis_.movement(set);
        if (movement && !progress.moves)
            progress.from_s = centre_s - static_cast<double>(Movement::slope_reach) * period_s;
        if (movement && movement->closed == 0)
            progress.to_s = centre_s;
        if (!movement && progress.moves)
            found.push_back(finding(set, progress, outcome));
        progress.moves = movement != nullptr;
    }
}

MovementFinding RecordDiagnosis::finding(LinkSet set, const Progress& progress, const SampleOutcome& outcome) const {
    MovementFinding finding{set, progress.from_s, progress.to_s, {}};
    const std::span<const LinkEstimate> estimates = diagnosis_.estimates(set)->links;
    for (Link link : links_of(set))
        finding.links.push_back(finding_of(link, estimates[position_in(set, link)], progress.from_s, settings_));
    const auto judged = std::ranges::find(outcome.judged, set, &JudgedMovement::set);
    for (std::size_t i = 0; judged != outcome.judged.end() && i < finding.links.size(); ++i)
        finding.links[i].whole = whole_movement(judged->links[i], diagnosis_.health_in3_per_psi(finding.links[i].link));
    for (LinkFinding& link : finding.links) {
        if (finding.links.size() > 1)
            confirm(link, finding.links.size());
        note_leak_or_offset(link);
        if (diagnosis_.verdict(link.link).verdict.kind == VerdictKind::sensor)
            link.flags.push_back({FlagKind::impossible,
                                  "impossible: no machine gives these readings, so this movement is not judged: "
                                  "check the sensor"});
    }
    return finding;
}

} // namespace placedpar::identification
