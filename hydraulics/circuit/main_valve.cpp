#include "hydraulics/circuit/main_valve.hpp"

#include "hydraulics/data/parameters.hpp"

#include <algorithm>
#include <cmath>

namespace placedpar::hydraulics {

namespace {

constexpr std::size_t bu = index_of(Link::bucket), bo = index_of(Link::boom), st = index_of(Link::stick),
                      sw = index_of(Link::swing);

bool stick_feeds_boom(Configuration now) { return now == Configuration::b || now == Configuration::d; }
bool boom_feeds_stick(Configuration now) { return now == Configuration::c || now == Configuration::e; }

} // namespace

BranchPressures branch_pressures(const PerLink<double>& junction_psi) {
    const double boom = junction_psi[bo], stick = junction_psi[st];
    return {std::min(junction_psi[bu], boom), boom, std::min(junction_psi[sw], stick), stick};
}

double MainValve::one_way(double area_in2, double drop_psi) const {
    if (drop_psi <= 0)
        return 0;
    const double k = flow.conductance(area_in2);
    return drop_psi > laminar_psi ? k * std::sqrt(drop_psi) : k * drop_psi / std::sqrt(laminar_psi);
}

ValveFlows MainValve::flows(Configuration now, const PerLink<double>& psi, const ValveLinks& links) const {
    PerLink<double> beyond;
    beyond[bu] = psi[bo];
    beyond[sw] = psi[st];
    beyond[bo] = boom_feeds_stick(now) ? psi[st] : flow.tank_psi;
    beyond[st] = stick_feeds_boom(now) ? psi[bo] : flow.tank_psi;
    ValveFlows flows;
    for (std::size_t i = 0; i < psi.size(); ++i) {
        flows.inlet[i] = one_way(links.inlet_in2[i], psi[i] - links.inlet_psi[i]);
        flows.bypass[i] = one_way(links.bypass_in2[i], psi[i] - beyond[i]);
        flows.relief[i] = std::max(psi[i] - flow.relief_psi, 0.0); // the relief valve passes 1 in^3/s for each psi
                                                                   // above its pressure
    }
    return flows;
}

PerLink<double> MainValve::rates(Configuration now, const ValveFlows& flows) const {
    PerLink<double> rates{};
    rates[bu] = rates[sw] = flow.pump_in3_per_s;
    rates[bo] = flows.bypass[bu] + (stick_feeds_boom(now) ? flows.bypass[st] : 0);
    rates[st] = flows.bypass[sw] + (boom_feeds_stick(now) ? flows.bypass[bo] : 0);
    for (std::size_t i = 0; i < rates.size(); ++i)
        rates[i] = (rates[i] - flows.inlet[i] - flows.bypass[i] - flows.relief[i]) / pipe_in3_per_psi;
    return rates;
}

MainValve main_valve(const Parameters& parameters) {
    return {flow_constants(parameters), parameters["pipe.volume"] / parameters["oil.bulk_modulus"],
            parameters["valve.drain_laminar"]};
}

} // namespace placedpar::hydraulics
