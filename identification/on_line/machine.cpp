#include "identification/on_line/machine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace placedpar::monitor {

using namespace hydraulics;

namespace {

/// A sample may come this part of a period early or late before the line through 5 of them is no longer one
/// through equally spaced points.
constexpr double jitter = 0.1;

/// Those of `a` that are not in `b`.
std::vector<Alarm> without(const std::vector<Alarm>& a, const std::vector<Alarm>& b) {
    std::vector<Alarm> rest;
    std::ranges::copy_if(a, std::back_inserter(rest),
                         [&](const Alarm& alarm) { return std::ranges::find(b, alarm) == b.end(); });
    return rest;
}

Machine::State new_machine(std::string name, const MachineParameters& parameters) {
    Machine::State state;
    state.name = std::move(name);
    state.parameters = parameters;
    return state;
}

} // namespace

Machine::Machine(std::string name, const MachineParameters& parameters, const DiagnosisSettings& settings,
                 std::uint64_t seed)
    : Machine(new_machine(std::move(name), parameters), settings, seed) {}

Machine::Machine(State state, const DiagnosisSettings& settings, std::uint64_t seed)
    : settings_(settings), seed_(seed), state_(std::move(state)), fit_(state_.parameters.period_s) {
    settings_.validate();
    for (auto& [links, set] : state_.sets)
        sets_.try_emplace(links, links, settings_, seed_, fmt::format("{}/{}", state_.name, name_of_set(links)),
                          std::move(set));
    state_.sets.clear();
}

Machine::State Machine::state() const {
    State copy = state_;
    for (const auto& [links, set] : sets_)
        copy.sets.emplace(links, set.state());
    return copy;
}

std::vector<LinkSet> Machine::sets_in_use() const {
    if (!state_.configuration)
        return {};
    return monitor::sets_in_use(*state_.configuration, state_.active);
}

PopulationSet& Machine::population(LinkSet set) {
    auto [place, made] =
        sets_.try_emplace(set, set, settings_, seed_, fmt::format("{}/{}", state_.name, name_of_set(set)));
    return place->second;
}

const SetProblem& Machine::problem(LinkSet set) {
    auto [place, made] = problems_.try_emplace({*state_.configuration, set}, *state_.configuration, set,
                                               state_.parameters.flow, settings_.bits);
    return place->second;
}

void Machine::change(const ConfigurationChange& change) {
    if (state_.configuration == change.configuration && state_.active == change.active)
        return;
    restart_windows(); // of the sets in use until now
    state_.configuration = change.configuration;
    state_.active = change.active;
    for (hydraulics::Link link : all_links)
        if (!state_.active.contains(link))
            state_.tracks[index_of(link)] = {}; // nobody tells its voltage any more
}

void Machine::restart_windows() {
    for (LinkTrack& track : state_.tracks)
        track.restart();
    for (LinkSet set : sets_in_use())
        if (auto found = sets_.find(set); found != sets_.end())
            found->second.restart_window();
}

void Machine::require_acceptable(const SampleMessage& message) const {
    if (!state_.configuration)
        throw BadMessage("type", "a sample before any configuration",
                         "first {\"type\":\"configuration\",\"configuration\":\"a\",\"active\":[\"BU\",\"BO\"]}");
    for (hydraulics::Link link : links_of(state_.active))
        if (!message.links[index_of(link)])
            throw BadMessage(fmt::format("links.{}", symbol_of(link)), "it is missing, and the link is active",
                             "a reading of each active link, or a configuration without it");
    if (state_.time_s && message.time_s <= *state_.time_s && !state_.time_may_restart)
        throw BadMessage("time_s", fmt::format("it is {}, not after the last sample's", message.time_s),
                         fmt::format("more than {}; after another hello time may begin anew", *state_.time_s));
}

std::optional<double> Machine::elapsed_s(double time_s) const {
    return state_.time_s && time_s > *state_.time_s ? std::optional(time_s - *state_.time_s) : std::nullopt;
}

SampleOutcome Machine::take(const SampleMessage& message) {
    require_acceptable(message);
    SampleOutcome outcome;
    std::optional<double> elapsed = elapsed_s(message.time_s);
    double period_s = state_.parameters.period_s;
    if (!elapsed || std::abs(*elapsed - period_s) > jitter * period_s) {
        outcome.window_restarted = state_.time_s.has_value();
        restart_windows();
    }
    state_.time_s = message.time_s;
    state_.time_may_restart = false;
    ++state_.samples;
    for (hydraulics::Link link : links_of(state_.active))
        state_.tracks[index_of(link)].push(*message.links[index_of(link)], state_.parameters.links[index_of(link)],
                                           elapsed);
    double centre_s = message.time_s - static_cast<double>(line_fit_points / 2) * period_s;
    for (LinkSet set : sets_in_use())
        outcome.generations += search(set, centre_s);
    settle_baselines();
    update_alarms(outcome);
    return outcome;
}

std::size_t Machine::search(LinkSet set, double centre_s) {
    SetSample samples;
    for (hydraulics::Link link : links_of(set)) {
        auto sample = state_.tracks[index_of(link)].centre(fit_, state_.parameters.links[index_of(link)]);
        if (!sample)
            return 0;
        samples.push_back(*sample);
    }
    return population(set).take(problem(set), samples, centre_s);
}

LinkCheck Machine::check(hydraulics::Link link) const {
    LinkCheck check{state_.baseline_in3_per_psi[index_of(link)], {}};
    double newest_s = 0;
    bool any = false;
    for (LinkSet set : all_population_sets()) {
        auto found = sets_.find(set);
        if (!set.contains(link) || found == sets_.end())
            continue;
        std::vector<hydraulics::Link> links = links_of(set);
        auto position = static_cast<std::size_t>(std::ranges::find(links, link) - links.begin());
        const Estimate& estimate = found->second.state().estimates[position];
        double settled_s = estimate.state().settled_time_s;
        if (!estimate.settled_in3_per_psi() || std::abs(*state_.time_s - settled_s) > settings_.stale_after_s)
            continue;
        check.estimates.push_back({set, *estimate.settled_in3_per_psi(), *estimate.lasting_in3_per_psi(),
                                   estimate.state().settled_in3_per_psi.size(), settled_s});
        if (!any || settled_s > newest_s)
            check.at_lower_bound = at_lower_bound(*estimate.settled_in3_per_psi(), settings_.step_in3_per_psi());
        newest_s = any ? std::max(newest_s, settled_s) : settled_s;
        any = true;
    }
    return check;
}

void Machine::settle_baselines() {
    for (const auto& [set, population] : sets_) {
        std::vector<hydraulics::Link> links = links_of(set);
        for (std::size_t i = 0; i < links.size(); ++i) {
            // The first settled value that will not move any more: at the end of its transient.
            const Estimate& estimate = population.state().estimates[i];
            auto& baseline = state_.baseline_in3_per_psi[index_of(links[i])];
            if (!baseline && !estimate.excited() && estimate.settled_in3_per_psi() &&
                !at_lower_bound(*estimate.settled_in3_per_psi(), settings_.step_in3_per_psi()))
                baseline = estimate.settled_in3_per_psi();
        }
    }
}

SampleOutcome Machine::set_baseline(const BaselineMessage& message) {
    for (hydraulics::Link link : all_links)
        if (const auto& compliance = message.compliance_in3_per_psi[index_of(link)])
            state_.baseline_in3_per_psi[index_of(link)] = *compliance;
    SampleOutcome outcome;
    update_alarms(outcome);
    return outcome;
}

void Machine::update_alarms(SampleOutcome& outcome) {
    PerLink<LinkCheck> checks;
    for (hydraulics::Link link : all_links)
        checks[index_of(link)] = check(link);
    std::vector<Alarm> now = find_alarms(checks, settings_);
    outcome.raised = without(now, state_.alarms);
    outcome.cleared = without(state_.alarms, now);
    state_.alarms = std::move(now);
}

} // namespace placedpar::monitor
