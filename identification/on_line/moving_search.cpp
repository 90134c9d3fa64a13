#include "identification/on_line/moving_search.hpp"

#include "identification/on_line/population_sets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace placedpar::identification {

using namespace hydraulics;

namespace {

bool excited(const std::vector<LinkSample>& links) {
    constexpr double least_slope_psi_per_s = 300; // this project's choice: four times the scatter from medium noise
    return std::ranges::any_of(
        links, [](const LinkSample& link) { return std::abs(link.inlet_slope_psi_per_s) > least_slope_psi_per_s; });
}

} // namespace

RecognisedMachine RecognisedMachine::of(const Parameters& parameters) {
    RecognisedMachine machine{main_valve(parameters), cross_over_limits(parameters)};
    for (Link link : all_links)
        machine.healthy_in3_per_psi[index_of(link)] = parameters[fmt::format("{}.inlet_compliance", name_of(link))];
    return machine;
}

MovingSearch::MovingSearch(const RecognisedMachine& machine, double period_s, WayFor way, std::uint64_t seed,
                           std::string prefix, std::size_t most_samples)
    : flow_(machine.valve.flow), way_(std::move(way)), seed_(seed), prefix_(std::move(prefix)),
      most_samples_(most_samples), watch_(machine.valve, machine.limits, machine.healthy_in3_per_psi, period_s) {}

MovingSearchState MovingSearch::state() const {
    MovingSearchState copy = state_;
    copy.watch = watch_.state();
    for (const auto& [set, search] : searches_)
        copy.searches.emplace(set, search.state());
    return copy;
}

void MovingSearch::go_on_from(MovingSearchState state) {
    watch_.go_on_from(std::exchange(state.watch, {}));
    for (auto& [set, search] : std::exchange(state.searches, {}))
        search_of(set).go_on_from(std::move(search));
    state_ = std::move(state);
}

std::vector<LinkSet> MovingSearch::take(const ValveReading& reading, double time_s) {
    watch_.take(reading);
    const Configuration before = std::exchange(state_.configuration, watch_.configuration());
    if (state_.configuration != before)
        state_.pending.clear();
    release(state_.pending);
    const std::vector<LinkSet> sets = sets_in_use(state_.configuration, watch_.driven());
    const std::vector<LinkSet> made = end_stretches(state_.configuration == before ? sets : std::vector<LinkSet>());
    for (LinkSet set : sets)
        collect(set, time_s);
    state_.in_use = sets;
    ++state_.readings;
    return made;
}

void MovingSearch::restart() {
    watch_.restart();
    state_.pending.clear();
}

/// Passes each waiting sample to the search of its set, as soon as the sample's configuration can no longer be
/// corrected.
void MovingSearch::release(std::vector<PendingSample>& pending) {
    for (; !pending.empty() && pending.front().sample.index + ConfigurationWatch::reach <= state_.readings;
         pending.erase(pending.begin()))
        search_of(pending.front().set).add(state_.configuration, std::move(pending.front().sample));
}

/// Makes a round of generations for each set in use that is not one of `sets`.
std::vector<LinkSet> MovingSearch::end_stretches(const std::vector<LinkSet>& sets) {
    std::vector<LinkSet> made;
    for (LinkSet set : state_.in_use)
        if (std::ranges::find(sets, set) == sets.end() && search_of(set).round())
            made.push_back(set);
    return made;
}

void MovingSearch::collect(LinkSet set, double time_s) {
    if (state_.readings < state_.next[set])
        return;
    auto links = watch_.samples(circuit_of(state_.configuration, set));
    if (!links || !excited(*links))
        return;
    state_.pending.push_back({set, {state_.readings, time_s, std::move(*links)}});
    state_.next[set] = state_.readings + ConfigurationWatch::span;
}

SetSearch& MovingSearch::search_of(LinkSet set) {
    auto found = searches_.find(set);
    if (found == searches_.end())
        found = searches_
                    .try_emplace(set, set, way_(set.size()), flow_,
                                 RandomStream(seed_, fmt::format("{}{}", prefix_, name_of_set(set))), most_samples_)
                    .first;
    return found->second;
}

std::vector<SetAnswer> MovingSearch::answers() {
    std::vector<SetAnswer> answers;
    for (LinkSet set : all_population_sets())
        if (auto found = searches_.find(set); found != searches_.end())
            if (auto answer = found->second.answer())
                answers.push_back(std::move(*answer));
    return answers;
}

} // namespace placedpar::identification
