#include "identification/on_line/moving_diagnosis.hpp"

#include "identification/on_line/moving_identification.hpp"
#include "identification/on_line/population_sets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace placedpar::identification {

using namespace hydraulics;

namespace {

RecognisedMachine recognised(const ExcavatorParameters& parameters) {
    RecognisedMachine machine = RecognisedMachine::of(Parameters::excavator());
    machine.valve.flow = parameters.flow;
    machine.healthy_in3_per_psi = parameters.compliance_in3_per_psi;
    return machine;
}

/// Returns the newest sample of all links.
ValveReading newest_reading(const PerLink<LinkTrack>& tracks, const PerLink<LinkConstants>& links) {
    ValveReading reading{};
    for (std::size_t i = 0; i < all_links.size(); ++i) {
        const LinkTrack::Newest newest = tracks[i].newest(links[i]);
        reading.links.inlet_psi[i] = newest.inlet_psi;
        reading.links.inlet_in2[i] = newest.inlet_in2;
        reading.links.bypass_in2[i] = newest.bypass_in2;
        reading.piston_in3[i] = newest.piston_in3;
    }
    return reading;
}

/// Returns the likelihood of the deviation `found`, if the true deviation is `truth`. Both are in standard errors.
double likelihood(double found, double truth) { return std::exp(-(found - truth) * (found - truth) / 2); }

/// Returns a deviation in which only the compliance differs from the compliance of a healthy link.
Deviation of_compliance(double units, double standard_error) {
    Deviation deviation;
    const std::size_t i = index_of(FaultHypothesis::compliance);
    deviation.by[i] = units;
    deviation.covariance[i * (all_hypotheses.size() + 1)] = standard_error * standard_error;
    return deviation;
}

/// Returns the estimates of a set of links as the answer of a search.
SetAnswer answer_of(LinkSet set, const std::vector<LinkEstimate>& estimates) {
    SetAnswer answer{set, "", 0, 0, {}};
    for (std::size_t i = 0; i < estimates.size(); ++i) {
        LinkIdentified link{links_of(set)[i], *estimates[i].compliance_in3_per_psi(),
                            estimates[i].state().standard_error_in3_per_psi};
        if (!estimates[i].state().fits)
            link.flags.push_back({FlagKind::unconfirmed, ""});
        answer.links.push_back(std::move(link));
    }
    return answer;
}

/// Sets kind, probability and deviation of the verdict on a link without a flag.
void judge(const LinkIdentified& link, double health_in3_per_psi, Verdict& verdict) {
    const double unit = WayUnits::of(health_in3_per_psi).compliance_in3_per_psi;
    const double units = (link.compliance_in3_per_psi - health_in3_per_psi) / unit, error = link.standard_error / unit;
    const double found = units / error, one = 1 / error, sound = likelihood(found, 0);
    verdict.deviation = of_compliance(units, error);
    const double share = WayUnits::compliance_share * std::abs(units);
    if (share > MovingDiagnosis::least_share && std::abs(found) > MovingDiagnosis::least_errors) {
        verdict.kind = VerdictKind::compliance;
        verdict.probability = 1 / (1 + sound);
        return;
    }
    verdict.probability = sound / (sound + likelihood(found, one) + likelihood(found, -one));
    verdict.kind = verdict.probability >= LinkJudge::least_sure_sound ? VerdictKind::sound : VerdictKind::cannot_tell;
}

} // namespace

MovingDiagnosis::MovingDiagnosis(const ExcavatorParameters& parameters, double period_s, std::uint64_t seed,
                                 const std::string& name)
    : links_(parameters.links),
      search_(
          recognised(parameters), period_s, [](std::size_t links) { return whole_way(links); }, seed, name + "/moving/",
          most_samples) {}

MovingDiagnosisState MovingDiagnosis::state() const { return {search_.state(), estimates_, impossible_}; }

void MovingDiagnosis::go_on_from(MovingDiagnosisState state) {
    search_.go_on_from(std::move(state.search));
    estimates_ = std::move(state.estimates);
    impossible_ = state.impossible;
    combine();
}

std::size_t MovingDiagnosis::take(const NewestSample& newest) {
    std::size_t generations = 0;
    const std::vector<LinkSet> made = search_.take(newest_reading(newest.tracks, links_), newest.time_s);
    for (LinkSet set : made) {
        note_round(set, newest.time_s);
        generations += whole_way(set.size()).way.search.window.trials;
    }
    if (!made.empty())
        combine();
    judgements_.changed |= generations > 0;
    return generations;
}

void MovingDiagnosis::note_impossible(Link link) {
    impossible_[index_of(link)] = search_.readings();
    search_.restart();
    judgements_.changed = true;
}

void MovingDiagnosis::note_round(LinkSet set, double time_s) {
    const SetAnswer answer = search_of(set).answer_so_far();
    std::vector<LinkEstimate>& estimates = estimates_[set];
    estimates.resize(set.size());
    for (std::size_t i = 0; i < estimates.size(); ++i) {
        const LinkIdentified& link = answer.links[i];
        estimates[i].answer(link.compliance_in3_per_psi, link.standard_error, time_s,
                            !link.flagged(FlagKind::unconfirmed));
        std::optional<std::size_t>& impossible = impossible_[index_of(link.link)];
        if (impossible && search_of(set).newest_index() >= *impossible + ConfigurationWatch::span)
            impossible.reset();
    }
}

void MovingDiagnosis::combine() {
    std::vector<SetAnswer> answers;
    for (const auto& [set, estimates] : estimates_)
        answers.push_back(answer_of(set, estimates));
    combined_ = combined_links(answers);
}

LinkSet MovingDiagnosis::active() const {
    LinkSet driven;
    for (LinkSet set : search_.in_use())
        for (Link link : links_of(set))
            driven.insert(link);
    return driven;
}

std::optional<SetEstimates> MovingDiagnosis::estimates(LinkSet set) const {
    auto found = estimates_.find(set);
    if (found == estimates_.end())
        return std::nullopt;
    return SetEstimates{set, search_of(set).samples(), search_of(set).generations(), found->second};
}

std::size_t MovingDiagnosis::rounds_with(Link link) const {
    std::size_t rounds = 0;
    for (const auto& [set, search] : search_.searches())
        rounds += set.contains(link) ? search.rounds() : 0;
    return rounds;
}

LinkVerdict MovingDiagnosis::verdict(Link link, double health_in3_per_psi) const {
    const WayUnits units = WayUnits::of(health_in3_per_psi);
    Verdict verdict;
    verdict.movements = rounds_with(link);
    const auto found = std::ranges::find(combined_, link, &LinkIdentified::link);
    if (impossible_[index_of(link)])
        verdict.kind = VerdictKind::sensor;
    else if (verdict.movements >= fewest_rounds && (found == combined_.end() || !found->flags.empty()))
        verdict.kind = VerdictKind::cannot_tell;
    else if (verdict.movements >= fewest_rounds)
        judge(*found, health_in3_per_psi, verdict);
    return {verdict, units};
}

} // namespace placedpar::identification
