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
    if (under_way())
        return close(std::move(sample));
    state_.opened = 0;
    if (all_shut(sample))
        rest(std::move(sample), state_.samples.at_rest, sampling_.samples_in(rest_s));
    else
        state_.shut.clear();
    return false;
}

void Movement::rest(JunctionSamples sample, std::vector<JunctionSamples>& kept, std::size_t most) {
    state_.shut.push_back(std::move(sample));
    if (state_.shut.size() <= slope_reach)
        return;
    if (kept.size() == most)
        kept.erase(kept.begin());
    kept.push_back(std::move(state_.shut.front()));
    state_.shut.erase(state_.shut.begin());
}

bool Movement::close(JunctionSamples sample) {
    const std::size_t rest_after = sampling_.samples_in(rest_after_s);
    ++state_.closed;
    if (all_shut(sample))
        rest(std::move(sample), state_.samples.rest_after, rest_after);
    else if (!state_.shut.empty() && !goes_on())
        return true; // a valve opens again
    else {
        state_.shut.clear();
        state_.samples.rest_after.clear();
    }
    return state_.closed >= sampling_.samples_in(shut_for_s) + rest_after;
}

bool Movement::move(JunctionSamples sample) {
    if (!goes_on())
        return true; // the next movement begins during the rest after the present movement
    state_.shut.clear();
    state_.samples.rest_after.clear();
    state_.closed = 0;
    if (state_.opened++ < slope_reach)
        return false;
    state_.samples.moving.push_back(std::move(sample));
    return state_.samples.moving.size() == sampling_.samples_in(piece_s);
}

MovementSamples Movement::finish() {
    MovementSamples over = std::move(state_.samples);
    if (state_.closed > 0)
        over.moving.resize(over.moving.size() - std::min(over.moving.size(), slope_ahead));
    const std::size_t reaching_back = std::min(over.rest_after.size(), slope_reach);
    over.rest_after.erase(over.rest_after.begin(),
                          over.rest_after.begin() + static_cast<std::ptrdiff_t>(reaching_back));
    state_ = {};
    return over;
}

} // namespace placedpar::identification
