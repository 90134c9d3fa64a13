#include "hydraulics/flow_split.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace placedpar {

namespace {

/// One orifice of the two: its coefficient k a, and the pressure it feeds.
struct Branch {
    double coefficient;
    double psi;
};

double square(double x) { return x * x; }

/// The pressure at which flow Q parts into two branches, none of which flows backwards; infinite when both
/// are shut. With u^2 the drop over `high`: Q = a u + b sqrt(u^2 + D), a quadratic in u whose positive root
/// is written without cancellation.
double common_psi(const Branch& high, const Branch& low, double flow) {
    double a = high.coefficient, b = low.coefficient, difference_psi = high.psi - low.psi;
    double rest = flow * flow - b * b * difference_psi;
    if (rest <= 0) // then b > 0
        return low.psi + square(flow / b);
    if (a == 0 && b == 0)
        return std::numeric_limits<double>::infinity();
    double u = rest / (flow * a + b * std::sqrt(rest + a * a * difference_psi));
    return high.psi + u * u;
}

double flow_through(const Branch& branch, double pump_psi) {
    return branch.coefficient * std::sqrt(std::max(pump_psi - branch.psi, 0.0));
}

} // namespace

FlowSplit split_flow(double inlet_in2, double bypass_in2, double inlet_psi, const FlowConstants& constants) {
    double k = constants.orifice_in3_per_s_in2_sqrt_psi, flow = constants.pump_in3_per_s;
    Branch inlet{k * inlet_in2, inlet_psi}, bypass{k * bypass_in2, constants.tank_psi};
    bool loaded = inlet.psi >= bypass.psi;
    double psi = loaded ? common_psi(inlet, bypass, flow) : common_psi(bypass, inlet, flow);
    if (psi > constants.relief_psi) {
        psi = constants.relief_psi;
        double in = flow_through(inlet, psi), by = flow_through(bypass, psi);
        return {psi, in, by, flow - in - by};
    }
    // The branch of the lower pressure takes the rest, so that the sum is exact to a rounding.
    if (loaded) {
        double in = flow_through(inlet, psi);
        return {psi, in, flow - in, 0};
    }
    double by = flow_through(bypass, psi);
    return {psi, flow - by, by, 0};
}

double bypass_only_psi(double bypass_in2, const FlowConstants& constants) {
    return constants.tank_psi +
           square(constants.pump_in3_per_s / (constants.orifice_in3_per_s_in2_sqrt_psi * bypass_in2));
}

} // namespace placedpar
