#include "hydraulics/circuit/cross_over.hpp"

#include "hydraulics/data/parameters.hpp"

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

/// Returns whether the check valve is shut. `before_psi`: the pressure on the pump's side of the valve.
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

} // namespace placedpar::hydraulics
