#include "hydraulics/circuit/configuration_watch.hpp"

#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>

#include <algorithm>
#include <cmath>

namespace placedpar::hydraulics {

namespace {

// This project chose these values by trials on fifty random jobs of a simulated machine.
constexpr double longest_step_s = 0.0004;
constexpr double laminar_psi = 20; ///< smaller values would make the step unstable
/// Another position of the valves is accepted only if it lowers the misfit by this value, in (in^3/s)^2.
constexpr double least_gain = 4000;
constexpr double misfit_left = 0.2;     ///< another position must also lower the misfit to at most this share
constexpr double doubt = 0.2;           ///< weight of the fall of the misfit if no pressure was near a limit
constexpr double near_share = 0.7;      ///< a pressure above this share of a limit counts as near the limit
constexpr double largest_square = 1e4;  ///< limits one flow's squared error, so that no single wrong reading decides
constexpr double back_in3_per_s = -5;   ///< if less oil flows into a cylinder, its outlet is open
constexpr double smoothing = 0.3;       ///< weight of a new reading in the smoothed flow of oil
constexpr double outlet_shuts_s = 0.75; ///< an outlet is assumed to be shut if no oil has left the cylinder for this
                                        ///< time: six times the pilot valve's lag
constexpr double steepest = 1;          ///< greatest change of a bypass's flow per change of the flow into the link
constexpr double least_inlet_in2 = 0.02, least_flow_in3_per_s = 10;

bool same_surplus(Configuration a, Configuration b) {
    auto surplus = [](Configuration each) {
        return each == Configuration::b ? Configuration::d : each == Configuration::c ? Configuration::e : each;
    };
    return surplus(a) == surplus(b);
}

ValveLinks between(const ValveLinks& a, const ValveLinks& b, double share) {
    auto mixed = [share](const PerLink<double>& from, const PerLink<double>& to) {
        PerLink<double> values;
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] = std::max(from[i] + share * (to[i] - from[i]), 0.0);
        return values;
    };
    return {mixed(a.inlet_psi, b.inlet_psi), mixed(a.inlet_in2, b.inlet_in2), mixed(a.bypass_in2, b.bypass_in2)};
}

} // namespace

ConfigurationWatch::ConfigurationWatch(const MainValve& valve, const CrossOverLimits& limits,
                                       const PerLink<double>& compliance_in3_per_psi, double period_s)
    : valve_(valve), limits_(limits), compliance_in3_per_psi_(compliance_in3_per_psi), period_s_(period_s) {
    valve_.laminar_psi = std::max(valve_.laminar_psi, laminar_psi);
    state_.last.junction_psi.fill(valve_.flow.tank_psi);
    state_.last.forward_s.fill(outlet_shuts_s);
}

void ConfigurationWatch::restart() {
    state_.recent.clear();
    state_.last.forward_s.fill(0);
}

void ConfigurationWatch::take(const ValveReading& reading) {
    if (state_.recent.empty())
        state_.last.end = reading;
    else
        state_.last = next(state_.last, reading, false);
    state_.recent.push_back(state_.last);
    if (state_.recent.size() > span + 1)
        state_.recent.erase(state_.recent.begin());
    reconsider();
}

ValveInterval ConfigurationWatch::next(const ValveInterval& from, const ValveReading& to, bool held) const {
    ValveInterval now = from;
    now.end = to;
    now.mean = {};
    now.misfit = 0;
    const double steps = std::ceil(period_s_ / longest_step_s), step_s = period_s_ / steps;
    boost::numeric::odeint::runge_kutta4<PerLink<double>> stepper;
    for (double step = 0; step < steps; ++step) {
        const ValveLinks links = between(from.end.links, to.links, (step + 0.5) / steps);
        const PerLink<double> before = now.junction_psi;
        auto rates = [&](const PerLink<double>& psi, PerLink<double>& rate, double) {
            rate = valve_.rates(now.configuration, valve_.flows(now.configuration, psi, links));
        };
        stepper.do_step(rates, now.junction_psi, 0.0, step_s);
        add_flows(now, before, links, 1 / steps);
        const auto then = next_configuration(now.configuration, branch_pressures(now.junction_psi), limits_);
        if (!held || same_surplus(then, now.configuration))
            now.configuration = then;
    }
    for (std::size_t i = 0; i < all_links.size(); ++i) {
        const double piston = (to.piston_in3[i] - from.end.piston_in3[i]) / period_s_;
        const double slope = (to.links.inlet_psi[i] - from.end.links.inlet_psi[i]) / period_s_;
        const double oil = piston + compliance_in3_per_psi_[i] * slope;
        now.oil_in3_per_s[i] += smoothing * (oil - now.oil_in3_per_s[i]);
        now.forward_s[i] = now.oil_in3_per_s[i] < back_in3_per_s ? 0 : from.forward_s[i] + period_s_;
        const double off = std::max(oil, 0.0) - now.mean.inlet[i];
        if (off > 0 || now.forward_s[i] > outlet_shuts_s) // an open outlet explains a lack of oil
            now.misfit += std::min(off * off, largest_square);
    }
    return now;
}

void ConfigurationWatch::add_flows(ValveInterval& now, const PerLink<double>& before_psi, const ValveLinks& links,
                                   double share) const {
    PerLink<double> middle_psi;
    for (std::size_t i = 0; i < all_links.size(); ++i)
        middle_psi[i] = (before_psi[i] + now.junction_psi[i]) / 2;
    const ValveFlows flows = valve_.flows(now.configuration, middle_psi, links);
    for (std::size_t i = 0; i < all_links.size(); ++i) {
        now.mean.inlet[i] += share * flows.inlet[i];
        now.mean.bypass[i] += share * flows.bypass[i];
    }
}

/// Returns whether the valves could just have moved to this position, because a pressure was near a limit.
bool ConfigurationWatch::near(const ValveInterval& interval, Configuration other) const {
    const CrossOverLimits near{near_share * limits_.shift_psi, near_share * limits_.release_psi, limits_.seat_psi};
    return same_surplus(next_configuration(interval.configuration, branch_pressures(interval.junction_psi), near),
                        other);
}

void ConfigurationWatch::reconsider() {
    std::vector<ValveInterval> best;
    double greatest_gain = least_gain, misfit = state_.recent.back().misfit;
    const std::size_t first = state_.recent.size() - std::min(state_.recent.size(), reach + 1);
    for (std::size_t from = state_.recent.size() - 1; from-- > first; misfit += state_.recent[from].misfit) {
        if (misfit < least_gain || from + 2 == state_.recent.size()) // noise could explain a single interval
            continue;
        for (Configuration other : {Configuration::a, Configuration::d, Configuration::e}) {
            if (same_surplus(other, state_.last.configuration))
                continue;
            std::vector<ValveInterval> path(state_.recent.begin(),
                                            state_.recent.begin() + static_cast<std::ptrdiff_t>(from) + 1);
            path.back().configuration = other;
            double left = 0;
            for (std::size_t i = from + 1; i < state_.recent.size() && left < misfit_left * misfit; ++i) {
                path.push_back(next(path.back(), state_.recent[i].end, true));
                left += path.back().misfit;
            }
            const double gain = (misfit - left) * (near(state_.recent[from + 1], other) ? 1 : doubt);
            if (left < misfit_left * misfit && gain > greatest_gain) {
                greatest_gain = gain;
                best = std::move(path);
            }
        }
    }
    if (best.empty())
        return;
    state_.recent = std::move(best);
    state_.last = state_.recent.back();
}

template <class Get>
double ConfigurationWatch::mean(Get get) const {
    double sum = 0;
    for (std::size_t i = 1; i < state_.recent.size(); ++i)
        sum += get(state_.recent[i]);
    return sum / static_cast<double>(state_.recent.size() - 1);
}

LinkSet ConfigurationWatch::driven() const {
    LinkSet driven;
    if (state_.recent.size() <= span)
        return driven;
    for (const ValveInterval& interval : state_.recent)
        if (interval.configuration != state_.last.configuration)
            return driven;
    for (Link link : all_links) {
        const std::size_t i = index_of(link);
        const bool fed = std::ranges::all_of(
            state_.recent, [&](const ValveInterval& each) { return each.end.links.inlet_in2[i] > least_inlet_in2; });
        if (fed && state_.last.forward_s[i] > outlet_shuts_s + span * period_s_ &&
            mean([&](const ValveInterval& each) { return each.mean.inlet[i]; }) > least_flow_in3_per_s)
            driven.insert(link);
    }
    return driven;
}

std::optional<std::vector<LinkSample>> ConfigurationWatch::samples(const Circuit& circuit) const {
    const ValveReading &first = state_.recent.front().end, &last = state_.recent.back().end;
    const double time_s = period_s_ * static_cast<double>(span);
    PerLink<double> psi, inlet, bypass, comes{};
    for (const Junction& junction : circuit) {
        const std::size_t i = index_of(junction.link);
        psi[i] = mean([&](const ValveInterval& each) { return each.junction_psi[i]; });
        inlet[i] = mean([&](const ValveInterval& each) { return each.mean.inlet[i]; });
        bypass[i] = junction.through == Through::nowhere
                        ? 0
                        : mean([&](const ValveInterval& each) { return each.mean.bypass[i]; });
        comes[i] += junction.pumps * valve_.flow.pump_in3_per_s;
        if (junction.through == Through::junction)
            comes[index_of(circuit[junction.next].link)] += bypass[i];
    }
    std::vector<LinkSample> samples;
    for (const Junction& junction : circuit) {
        const std::size_t i = index_of(junction.link);
        const double link_psi = mean([&](const ValveInterval& each) { return each.end.links.inlet_psi[i]; });
        const double other = comes[i] - inlet[i] - bypass[i]; // flow into pipes and into the other links
        const double beyond =
            junction.through == Through::junction ? psi[index_of(circuit[junction.next].link)] : valve_.flow.tank_psi;
        const double through = inlet[i] + other, k = valve_.flow.conductance(1);
        if (!(through > 0 && psi[i] > link_psi &&
              bypass[i] * (psi[i] - link_psi) <= steepest * through * (psi[i] - beyond)))
            return std::nullopt;
        samples.push_back({link_psi, (last.links.inlet_psi[i] - first.links.inlet_psi[i]) / time_s,
                           (last.piston_in3[i] - first.piston_in3[i]) / time_s + other,
                           through / (k * std::sqrt(psi[i] - link_psi)),
                           bypass[i] > 0 ? bypass[i] / (k * std::sqrt(psi[i] - beyond)) : 0});
    }
    return samples;
}

} // namespace placedpar::hydraulics
