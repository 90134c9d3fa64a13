#include "identification/verdict/movement.hpp"

#include "hydraulics/circuit/circuit_sample.hpp"

#include <algorithm>
#include <utility>

namespace placedpar::identification {

using namespace hydraulics;

namespace {

bool opened_wide(const Circuit& circuit, const FlowConstants& flow, const JunctionSamples& sample) {
    return std::ranges::all_of(sample,
                               [](const LinkSample& link) { return link.inlet_in2 >= Movement::least_inlet_in2; }) &&
           all_open(circuit, sample, flow, Movement::open_by_psi);
}

bool all_shut(const JunctionSamples& sample) {
    return std::ranges::all_of(sample, [](const LinkSample& link) { return link.inlet_in2 <= 0; });
}

} // namespace

bool Movement::take(const Circuit& circuit, const FlowConstants& flow, JunctionSamples sample) {
    if (opened_wide(circuit, flow, sample))
        return move(std::move(sample));
    state_.opened = under_way() ? state_.opened : 0;
    if (under_way())
        return ++state_.closed >= sampling_.samples_in(shut_for_s);
    if (all_shut(sample))
        rest(std::move(sample));
    else
        state_.shut.clear();
    return false;
}

void Movement::rest(JunctionSamples sample) {
    state_.shut.push_back(std::move(sample));
    if (state_.shut.size() <= slope_reach)
        return;
    std::vector<JunctionSamples>& at_rest = state_.samples.at_rest;
    if (at_rest.size() == sampling_.samples_in(rest_s))
        at_rest.erase(at_rest.begin());
    at_rest.push_back(std::move(state_.shut.front()));
    state_.shut.erase(state_.shut.begin());
}

bool Movement::move(JunctionSamples sample) {
    state_.shut.clear();
    state_.closed = 0;
    if (state_.opened++ < slope_reach)
        return false;
    state_.samples.moving.push_back(std::move(sample));
    return state_.samples.moving.size() == sampling_.samples_in(piece_s);
}

MovementSamples Movement::finish() {
    State over = std::exchange(state_, {});
    if (over.closed > 0)
        over.samples.moving.resize(over.samples.moving.size() - std::min(over.samples.moving.size(), slope_ahead));
    return over.samples;
}

} // namespace placedpar::identification
