#include "identification/on_line/diagnosis.hpp"

#include "identification/on_line/refused_sample.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace placedpar::identification {

using namespace hydraulics;

namespace {

/// The share of a period by which a sample may be early or late. Beyond it, 5 samples no longer count as equally
/// spaced, and the windows begin anew.
constexpr double jitter = 0.1;

/// The alarms of `a` that are not in `b`.
std::vector<Alarm> without(const std::vector<Alarm>& a, const std::vector<Alarm>& b) {
    std::vector<Alarm> rest;
    std::ranges::copy_if(a, std::back_inserter(rest),
                         [&](const Alarm& alarm) { return std::ranges::find(b, alarm) == b.end(); });
    return rest;
}

Diagnosis::State first_state_of(std::string name, const ExcavatorParameters& parameters) {
    Diagnosis::State state;
    state.name = std::move(name);
    state.parameters = parameters;
    return state;
}

} // namespace

Diagnosis::Diagnosis(std::string name, const ExcavatorParameters& parameters, const DiagnosisSettings& settings,
                     std::uint64_t seed)
    : Diagnosis(first_state_of(std::move(name), parameters), settings, seed) {}

Diagnosis::Diagnosis(State state, const DiagnosisSettings& settings, std::uint64_t seed)
    : settings_(settings), seed_(seed), state_(std::move(state)), fit_(state_.parameters.period_s) {
    settings_.validate();
    for (auto& [links, set] : state_.sets)
        sets_.try_emplace(links, links, settings_, seed_, fmt::format("{}/{}", state_.name, name_of_set(links)),
                          std::move(set));
    state_.sets.clear();
}

Diagnosis::State Diagnosis::state() const {
    State copy = state_;
    for (const auto& [links, set] : sets_)
        copy.sets.emplace(links, set.state());
    return copy;
}

std::vector<LinkSet> Diagnosis::sets_in_use() const {
    if (!state_.configuration)
        return {};
    return identification::sets_in_use(*state_.configuration, state_.active);
}

PopulationSet& Diagnosis::population(LinkSet set) {
    auto [place, made] =
        sets_.try_emplace(set, set, settings_, seed_, fmt::format("{}/{}", state_.name, name_of_set(set)));
    return place->second;
}

const SetProblem& Diagnosis::problem(LinkSet set) {
    auto [place, made] = problems_.try_emplace({*state_.configuration, set}, *state_.configuration, set,
                                               state_.parameters.flow, settings_.bits);
    return place->second;
}

void Diagnosis::change(const ConfigurationChange& change) {
    if (state_.configuration == change.configuration && state_.active == change.active)
        return;
    restart_windows(); // of the sets in use until now
    state_.configuration = change.configuration;
    state_.active = change.active;
    for (Link link : all_links)
        if (!state_.active.contains(link))
            state_.tracks[index_of(link)] = {}; // its voltage is not read any more
}

void Diagnosis::restart_windows() {
    for (LinkTrack& track : state_.tracks)
        track.restart();
    for (LinkSet set : sets_in_use())
        if (auto found = sets_.find(set); found != sets_.end())
            found->second.restart_window();
}

void Diagnosis::require_acceptable(const ExcavatorSample& sample) const {
    if (!state_.configuration)
        throw RefusedSample(NoConfiguration{});
    for (Link link : links_of(state_.active))
        if (!sample.links[index_of(link)])
            throw RefusedSample(LinkNotRead{link});
    if (state_.time_s && sample.time_s <= *state_.time_s && !state_.time_may_restart)
        throw RefusedSample(TimeNotLater{sample.time_s, *state_.time_s});
}

std::optional<double> Diagnosis::elapsed_s(double time_s) const {
    return state_.time_s && time_s > *state_.time_s ? std::optional(time_s - *state_.time_s) : std::nullopt;
}

void Diagnosis::push(const ExcavatorSample& sample, std::optional<double> elapsed_s) {
    state_.time_s = sample.time_s;
    state_.time_may_restart = false;
    ++state_.samples;
    for (Link link : links_of(state_.active))
        state_.tracks[index_of(link)].push(*sample.links[index_of(link)], state_.parameters.links[index_of(link)],
                                           elapsed_s);
}

SampleOutcome Diagnosis::take(const ExcavatorSample& sample) {
    require_acceptable(sample);
    SampleOutcome outcome;
    std::optional<double> elapsed = elapsed_s(sample.time_s);
    double period_s = state_.parameters.period_s;
    if (!elapsed || std::abs(*elapsed - period_s) > jitter * period_s) {
        outcome.window_restarted = state_.time_s.has_value();
        restart_windows();
    }
    push(sample, elapsed);
    double centre_s = sample.time_s - static_cast<double>(line_fit_points / 2) * period_s;
    for (LinkSet set : sets_in_use())
        outcome.generations += search(set, centre_s);
    settle_baselines();
    update_alarms(outcome);
    return outcome;
}

std::size_t Diagnosis::search(LinkSet set, double centre_s) {
    SetSample samples;
    for (Link link : links_of(set)) {
        auto sample = state_.tracks[index_of(link)].centre(fit_, state_.parameters.links[index_of(link)]);
        if (!sample)
            return 0;
        samples.push_back(*sample);
    }
    return population(set).take(problem(set), samples, centre_s);
}

LinkCheck Diagnosis::check(Link link) const {
    LinkCheck check{state_.baseline_in3_per_psi[index_of(link)], {}};
    for (LinkSet set : all_population_sets()) {
        auto found = sets_.find(set);
        if (!set.contains(link) || found == sets_.end())
            continue;
        const LinkEstimate& estimate = found->second.state().estimates[position_in(set, link)];
        double settled_s = estimate.state().settled_time_s;
        if (!estimate.settled_in3_per_psi() || std::abs(*state_.time_s - settled_s) > settings_.stale_after_s)
            continue;
        check.estimates.push_back({set, *estimate.settled_in3_per_psi(), *estimate.lasting_in3_per_psi(),
                                   estimate.state().settled_in3_per_psi.size(), settled_s});
    }
    if (!check.estimates.empty())
        check.at_lower_bound = at_lower_bound(check.newest().compliance_in3_per_psi, settings_.step_in3_per_psi());
    return check;
}

void Diagnosis::settle_baselines() {
    for (const auto& [set, population] : sets_) {
        std::vector<Link> links = links_of(set);
        for (std::size_t i = 0; i < links.size(); ++i) {
            // The first settled value whose transient is over, so that it moves no more.
            const LinkEstimate& estimate = population.state().estimates[i];
            auto& baseline = state_.baseline_in3_per_psi[index_of(links[i])];
            if (!baseline && !estimate.excited() && estimate.settled_in3_per_psi() &&
                !at_lower_bound(*estimate.settled_in3_per_psi(), settings_.step_in3_per_psi()))
                baseline = estimate.settled_in3_per_psi();
        }
    }
}

SampleOutcome Diagnosis::set_baseline(const Baseline& baseline) {
    for (Link link : all_links)
        if (const auto& compliance = baseline.compliance_in3_per_psi[index_of(link)])
            state_.baseline_in3_per_psi[index_of(link)] = *compliance;
    SampleOutcome outcome;
    update_alarms(outcome);
    return outcome;
}

void Diagnosis::update_alarms(SampleOutcome& outcome) {
    PerLink<LinkCheck> checks;
    for (Link link : all_links)
        checks[index_of(link)] = check(link);
    std::vector<Alarm> now = find_alarms(checks, settings_);
    outcome.raised = without(now, state_.alarms);
    outcome.cleared = without(state_.alarms, now);
    state_.alarms = std::move(now);
}

} // namespace placedpar::identification
