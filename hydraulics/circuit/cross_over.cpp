#include "hydraulics/circuit/cross_over.hpp"

#include "hydraulics/data/parameters.hpp"

#include <algorithm>

namespace placedpar::hydraulics {

namespace {

enum class Surplus { to_tank, to_boom, to_stick };

Surplus surplus_of(Configuration configuration) {
    switch (configuration) {
    case Configuration::a: break;
    case Configuration::b:
    case Configuration::d: return Surplus::to_boom;
    case Configuration::c:
    case Configuration::e: return Surplus::to_stick;
    }
    return Surplus::to_tank;
}

Surplus next_surplus(Surplus now, double boom_over_stick_psi, const CrossOverLimits& limits) {
    switch (now) {
    case Surplus::to_boom: return boom_over_stick_psi < -limits.release_psi ? Surplus::to_tank : now;
    case Surplus::to_stick: return boom_over_stick_psi > limits.release_psi ? Surplus::to_tank : now;
    case Surplus::to_tank: break;
    }
    if (boom_over_stick_psi > limits.shift_psi)
        return Surplus::to_boom;
    return boom_over_stick_psi < -limits.shift_psi ? Surplus::to_stick : now;
}

/// Returns whether the check valve is shut. `before` is the line towards the pump.
bool shut(bool now, double before_psi, double behind_psi, const CrossOverLimits& limits) {
    return behind_psi - before_psi > (now ? 0 : limits.seat_psi);
}

} // namespace

CrossOverLimits cross_over_limits(const Parameters& parameters) {
    return {parameters["cross_over.shift"], parameters["cross_over.release"], parameters["cross_over.seat"]};
}

Configuration next_configuration(Configuration now, const BranchPressures& branch, const CrossOverLimits& limits) {
    switch (next_surplus(surplus_of(now), branch.p13_psi - branch.p23_psi, limits)) {
    case Surplus::to_tank: break;
    case Surplus::to_boom:
        return shut(now == Configuration::b, branch.p12_psi, branch.p13_psi, limits) ? Configuration::b
                                                                                     : Configuration::d;
    case Surplus::to_stick:
        return shut(now == Configuration::c, branch.p22_psi, branch.p23_psi, limits) ? Configuration::c
                                                                                     : Configuration::e;
    }
    return Configuration::a;
}

BranchPressures branch_pressures(Configuration configuration, const PerLink<JunctionOpening>& openings,
                                 const FlowConstants& flow) {
    PerLink<double> psi{};
    for (LinkSet group : coupled_groups(configuration)) {
        const Circuit circuit = circuit_of(configuration, group);
        std::vector<JunctionOpening> at;
        for (const Junction& junction : circuit)
            at.push_back(openings[index_of(junction.link)]);
        const std::vector<JunctionFlow> flows = solve_junctions(circuit, at, flow);
        for (std::size_t j = 0; j < circuit.size(); ++j)
            psi[index_of(circuit[j].link)] = flows[j].psi;
    }
    const double boom = psi[index_of(Link::boom)], stick = psi[index_of(Link::stick)];
    // An open check valve has the same pressure on both sides. The line before a shut check valve has the pump's
    // pressure.
    const bool alone_1 = configuration == Configuration::b, alone_2 = configuration == Configuration::c;
    const double pump_1 = psi[index_of(Link::bucket)], pump_2 = psi[index_of(Link::swing)];
    return {alone_1 ? pump_1 : std::min(pump_1, boom), boom, alone_2 ? pump_2 : std::min(pump_2, stick), stick};
}

Configuration settled_configuration(Configuration now, const PerLink<JunctionOpening>& openings,
                                    const FlowConstants& flow, const CrossOverLimits& limits) {
    constexpr int most_moves = 8;
    for (int move = 0; move < most_moves; ++move) {
        const Configuration next = next_configuration(now, branch_pressures(now, openings, flow), limits);
        if (next == now)
            break;
        now = next;
    }
    return now;
}

} // namespace placedpar::hydraulics
