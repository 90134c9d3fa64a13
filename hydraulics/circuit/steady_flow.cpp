#include "hydraulics/circuit/steady_flow.hpp"

#include "hydraulics/circuit/boom_orifices.hpp"

#include <boost/math/tools/roots.hpp>
#include <fmt/format.h>

#include <cstdint>
#include <stdexcept>

namespace placedpar::hydraulics {

namespace {

/// Returns the central difference with a fixed step. Its relative error is about (step / L)^2 if the slope of `f`
/// changes noticeably over the distance L.
template <class Function>
double slope(const Function& f, double at, double step) {
    return (f(at + step) - f(at - step)) / (2 * step);
}

} // namespace

FlowSplit steady_boom_flow(double spool_in, double inlet_psi, const FlowConstants& constants) {
    OrificeAreas areas = boom_orifices(spool_in);
    return split_flow(areas.inlet_in2, areas.bypass_in2, inlet_psi, constants);
}

double boom_spool_for_flow(double inlet_in3_per_s, double inlet_psi, const FlowConstants& constants) {
    auto excess = [&](double spool_in) {
        return steady_boom_flow(spool_in, inlet_psi, constants).inlet_in3_per_s - inlet_in3_per_s;
    };
    double greatest = inlet_in3_per_s + excess(boom_bypass_shut_in);
    if (!(inlet_in3_per_s > 0) || !(inlet_in3_per_s <= greatest))
        throw std::domain_error(fmt::format(
            "no position of the spool gives {} in^3/s at {} psi: expected more than 0 and at most {} in^3/s",
            inlet_in3_per_s, inlet_psi, greatest));
    std::uintmax_t iterations = 100;
    auto [below, above] = boost::math::tools::toms748_solve(excess, boom_dead_band_in, boom_bypass_shut_in,
                                                            boost::math::tools::eps_tolerance<double>(48), iterations);
    return (below + above) / 2;
}

FlowSensitivity boom_flow_sensitivity(double spool_in, double inlet_psi, const FlowConstants& constants) {
    auto flow = [&](double spool, double psi) { return steady_boom_flow(spool, psi, constants).inlet_in3_per_s; };
    return {slope([&](double spool) { return flow(spool, inlet_psi); }, spool_in, 1e-5),
            slope([&](double psi) { return flow(spool_in, psi); }, inlet_psi, 0.01)};
}

} // namespace placedpar::hydraulics
