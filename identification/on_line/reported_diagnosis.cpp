#include "identification/on_line/reported_diagnosis.hpp"

#include "identification/on_line/population_sets.hpp"

#include <fmt/format.h>

#include <utility>

namespace placedpar::identification {

using namespace hydraulics;

namespace {

AreasFrom areas_from(const std::variant<SpoolPosition, ServoVoltage, ValveAreas>& valve) {
    if (std::holds_alternative<ServoVoltage>(valve))
        return AreasFrom::servo;
    return std::holds_alternative<SpoolPosition>(valve) ? AreasFrom::spool : AreasFrom::areas;
}

std::vector<double> of_set(LinkSet set, const PerLink<double>& values) {
    std::vector<double> of;
    for (Link link : links_of(set))
        of.push_back(values[index_of(link)]);
    return of;
}

} // namespace

ReportedDiagnosis::ReportedDiagnosis(const ExcavatorParameters& parameters, const DiagnosisSettings& settings,
                                     std::uint64_t seed, const std::string& name)
    : parameters_(parameters), settings_(settings), seed_(seed), name_(name),
      sampling_(Sampling::of(parameters.period_s)), fit_(sampling_.period_s()) {}

void ReportedDiagnosis::go_on_from(std::map<LinkSet, PopulationSet::State> sets, Watches watches, bool judged) {
    for (auto& [links, set] : sets)
        sets_.try_emplace(links, links, settings_, seed_, fmt::format("{}/{}", name_, name_of_set(links)),
                          std::move(set));
    watches_ = std::move(watches);
    judgements_.changed = judged;
}

const Movement::State* ReportedDiagnosis::movement(LinkSet set) const {
    auto found = watches_.find(set);
    bool moves = found != watches_.end() && !found->second.movement.samples.moving.empty();
    return moves ? &found->second.movement : nullptr;
}

void ReportedDiagnosis::report(std::optional<Configuration> configuration, LinkSet active) {
    configuration_ = configuration;
    active_ = active;
}

void ReportedDiagnosis::forget(Link link) {
    for (auto& [set, state] : watches_)
        if (set.contains(link))
            state.judges[position_in(set, link)] = {};
}

std::vector<LinkSet> ReportedDiagnosis::sets_in_use() const {
    return configuration_ ? identification::sets_in_use(*configuration_, active_) : std::vector<LinkSet>();
}

SetWatch::State& ReportedDiagnosis::watch_of(LinkSet set) {
    return watches_.try_emplace(set, SetWatch::first_state(set)).first->second;
}

PopulationSet& ReportedDiagnosis::population(LinkSet set) {
    auto [place, made] = sets_.try_emplace(set, set, settings_, seed_, fmt::format("{}/{}", name_, name_of_set(set)));
    return place->second;
}

const SetProblem& ReportedDiagnosis::problem(LinkSet set) {
    auto [place, made] =
        problems_.try_emplace({*configuration_, set}, *configuration_, set, parameters_.flow, settings_.bits);
    return place->second;
}

std::size_t ReportedDiagnosis::take(const NewestSample& newest) {
    std::size_t generations = 0;
    for (LinkSet set : sets_in_use())
        generations += search(set, newest);
    return generations;
}

std::size_t ReportedDiagnosis::search(LinkSet set, const NewestSample& newest) {
    SetSample samples;
    for (Link link : links_of(set)) {
        const LinkTrack& track = newest.tracks[index_of(link)];
        auto centre = track.centre(fit_, parameters_.links[index_of(link)]);
        if (!centre)
            return 0;
        samples.push_back(*centre);
        if (track.spikes(sampling_.period_s()))
            note_impossible(set, link);
    }
    watch(set, samples, newest);
    const double centre_s = newest.time_s - static_cast<double>(line_fit_points / 2) * sampling_.period_s();
    return population(set).take(problem(set), samples, centre_s);
}

void ReportedDiagnosis::watch(LinkSet set, const SetSample& centre, const NewestSample& newest) {
    std::vector<AreasFrom> valves;
    for (Link link : links_of(set))
        valves.push_back(areas_from(newest.reading.links[index_of(link)]->valve));
    const std::vector<double> health = of_set(set, newest.health_in3_per_psi);
    SetWatch::State& state = watch_of(set);
    SetWatch watch(sampling_, std::move(state));
    if (watch.note_moving_shut(problem(set), centre, health))
        judgements_.changed = true;
    note(set, watch.take(problem(set), centre, valves, health));
    state = watch.state();
}

void ReportedDiagnosis::restart(const PerLink<double>& health_in3_per_psi) {
    for (LinkSet set : sets_in_use()) {
        SetWatch::State& state = watch_of(set);
        SetWatch watch(sampling_, std::move(state));
        note(set, watch.end_movement(problem(set), of_set(set, health_in3_per_psi)));
        state = watch.state();
        if (auto found = sets_.find(set); found != sets_.end())
            found->second.restart_window();
    }
}

void ReportedDiagnosis::note(LinkSet set, std::optional<std::vector<Deviation>> judged) {
    if (!judged)
        return;
    judgements_.changed = true;
    judgements_.movements.push_back({set, std::move(*judged)});
}

void ReportedDiagnosis::note_impossible(Link link) {
    judgements_.changed = true;
    for (LinkSet set : sets_in_use())
        if (set.contains(link))
            note_impossible(set, link);
}

void ReportedDiagnosis::note_impossible(LinkSet set, Link link) {
    SetWatch::State& state = watch_of(set);
    SetWatch watch(sampling_, std::move(state));
    watch.note_impossible(position_in(set, link));
    state = watch.state();
    judgements_.changed = true;
}

std::optional<SetEstimates> ReportedDiagnosis::estimates(LinkSet set) const {
    auto found = sets_.find(set);
    if (found == sets_.end())
        return std::nullopt;
    const PopulationSet::State& state = found->second.state();
    return SetEstimates{set, state.window.size(), state.generations, state.estimates};
}

LinkVerdict ReportedDiagnosis::verdict(Link link, double health_in3_per_psi) const {
    auto weight = [](const Verdict& verdict) {
        bool fault = alarm_of(verdict.kind).has_value();
        return std::pair(fault, verdict.movements);
    };
    Verdict most;
    for (const auto& [set, state] : watches_)
        if (set.contains(link))
            if (Verdict verdict = LinkJudge(state.judges[position_in(set, link)]).verdict();
                weight(verdict) > weight(most))
                most = verdict;
    return {most, WayUnits::of(health_in3_per_psi)};
}

double ReportedDiagnosis::baseline_in3_per_psi(Link link, double health_in3_per_psi) const {
    for (const auto& [set, state] : watches_)
        if (set.contains(link))
            if (auto own = LinkJudge(state.judges[position_in(set, link)]).baseline())
                return health_in3_per_psi + WayUnits::of(health_in3_per_psi).compliance_in3_per_psi * own->by[0];
    return health_in3_per_psi;
}

} // namespace placedpar::identification
