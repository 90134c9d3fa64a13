#include "hydraulics/plant/hose.hpp"
#include "tests/nearly.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <vector>

using namespace placedpar;
using namespace placedpar::hydraulics;

namespace {

/// Simulates a line that is shut at both ends, whose pressures differ by 100 psi at first. Returns the flow at every
/// microsecond; the method is semi-implicit Euler.
std::vector<double> ringing(const Hose& hose, const HoseEnds& ends, double duration_s) {
    constexpr double step_s = 1e-6;
    HoseLine line{1700, 0, 1600};
    std::vector<double> flow;
    for (double time_s = 0; time_s < duration_s; time_s += step_s) {
        line.flow_in3_per_s +=
            step_s * rates_of(hose, ends.valve_in3_per_psi, ends.cylinder_in3_per_psi, line, 0, 0).flow_in3_per_s;
        HoseLine rate = rates_of(hose, ends.valve_in3_per_psi, ends.cylinder_in3_per_psi, line, 0, 0);
        line.first_psi += step_s * rate.first_psi;
        line.second_psi += step_s * rate.second_psi;
        flow.push_back(line.flow_in3_per_s);
    }
    return flow;
}

/// Returns the seconds between the first and the third change of sign: one period.
double period_s(const std::vector<double>& flow) {
    std::vector<std::size_t> crossings;
    for (std::size_t i = 1; i < flow.size(); ++i)
        if ((flow[i - 1] > 0) != (flow[i] > 0))
            crossings.push_back(i);
    return static_cast<double>(crossings.at(2) - crossings.at(0)) * 1e-6;
}

} // namespace

TEST_CASE("a hose rings at sqrt((1/C1 + 1/C2) / I)") {
    Hose hose{0.01215, 0, 0.3};
    HoseEnds ends = ends_of(hose, 0.0086);
    CHECK(ends.valve_in3_per_psi == test::nearly(0.00258));
    CHECK(ends.cylinder_in3_per_psi == doctest::Approx(0.00602));
    // (1/.00258 + 1/.00602) / .01215 = 45573, root 213.5 rad/s, 33.98 Hz
    CHECK(natural_rad_per_s(hose, ends) == doctest::Approx(213.5).epsilon(1e-3));
    CHECK(1 / period_s(ringing(hose, ends, 0.1)) == doctest::Approx(33.98).epsilon(1e-3));
}

TEST_CASE("a hose's ringing decays at R / (2 I) and is slowed by damping") {
    Hose hose{0.01215, 1, 0.3};
    HoseEnds ends = ends_of(hose, 0.0086);
    double natural = natural_rad_per_s(hose, ends), decay_per_s = 1 / (2 * 0.01215);
    double damped = std::sqrt(natural * natural - decay_per_s * decay_per_s);
    std::vector<double> flow = ringing(hose, ends, 0.1);
    double period = period_s(flow);
    CHECK(period == doctest::Approx(2 * std::numbers::pi / damped).epsilon(1e-3));
    auto at = [&](double time_s) { return flow.at(static_cast<std::size_t>(std::lround(time_s * 1e6))); };
    CHECK(at(0.005 + period) / at(0.005) == doctest::Approx(std::exp(-decay_per_s * period)).epsilon(5e-3));
}
