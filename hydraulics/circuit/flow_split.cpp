#include "hydraulics/circuit/flow_split.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace placedpar::hydraulics {

namespace {

/// Returns the pressure at which two outlets together take the flow Q; infinite if both are shut. The equation is Q = a
/// u + b sqrt(u^2 + D). u^2 is the pressure drop over `high`, D the difference between the outlets' pressures, and a
/// and b are the conductances. The formula for its positive root subtracts no nearly equal numbers, so that no digits
/// are lost.
double common_psi(const Outlet& high, const Outlet& low, double flow) {
    double a = high.conductance, b = low.conductance, difference_psi = high.psi - low.psi;
    double rest = flow * flow - b * b * difference_psi;
    if (rest <= 0) // then b > 0
        return low.psi + orifice_drop(b, flow);
    if (a == 0 && b == 0)
        return std::numeric_limits<double>::infinity();
    double u = rest / (flow * a + b * std::sqrt(rest + a * a * difference_psi));
    return high.psi + u * u;
}

} // namespace

FlowSplit split_flow(const Outlet& inlet, const Outlet& bypass, double flow_in3_per_s, double relief_psi) {
    bool loaded = inlet.psi >= bypass.psi;
    double psi = loaded ? common_psi(inlet, bypass, flow_in3_per_s) : common_psi(bypass, inlet, flow_in3_per_s);
    if (psi > relief_psi) {
        double in = flow_through(inlet, relief_psi), by = flow_through(bypass, relief_psi);
        return {relief_psi, in, by, flow_in3_per_s - in - by};
    }
    // The outlet with the lower pressure takes the remaining flow, so that the sum of the flows is exact, except for
    // rounding. A shut outlet takes nothing.
    if (inlet.conductance == 0 || bypass.conductance == 0)
        return {psi, inlet.conductance == 0 ? 0 : flow_in3_per_s, inlet.conductance == 0 ? flow_in3_per_s : 0, 0};
    if (loaded) {
        double in = flow_through(inlet, psi);
        return {psi, in, std::max(flow_in3_per_s - in, 0.0), 0};
    }
    double by = flow_through(bypass, psi);
    return {psi, std::max(flow_in3_per_s - by, 0.0), by, 0};
}

FlowSplit split_flow(double inlet_in2, double bypass_in2, double inlet_psi, const FlowConstants& constants) {
    return split_flow(Outlet{constants.conductance(inlet_in2), inlet_psi},
                      Outlet{constants.conductance(bypass_in2), constants.tank_psi}, constants.pump_in3_per_s,
                      constants.relief_psi);
}

double bypass_only_psi(double bypass_in2, const FlowConstants& constants) {
    return constants.tank_psi + orifice_drop(constants.conductance(bypass_in2), constants.pump_in3_per_s);
}

} // namespace placedpar::hydraulics
