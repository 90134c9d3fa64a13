#include "hydraulics/circuit/boom_orifices.hpp"
#include "hydraulics/circuit/circuit_error.hpp"
#include "runtime/lanes.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace placedpar {

using namespace hydraulics;

namespace {

const Circuit boom_alone = circuit_of(Configuration::a, {Link::boom});
const Circuit bucket_and_boom = circuit_of(Configuration::a, {Link::bucket, Link::boom});

/// Returns a sample at constant pressure with this flow into the link. Without a slope the compliance does not matter.
LinkSample steady(double psi, double flow, double inlet_in2, double bypass_in2) {
    return {psi, 0, flow, inlet_in2, bypass_in2};
}

template <std::size_t N>
double error_of(const Circuit& circuit, const std::array<double, N>& compliance,
                const std::array<LinkSample, N>& samples) {
    return circuit_error_in3_per_s<double>(circuit, std::span<const double>(compliance), samples,
                                           rounded_flow_constants(), printed_inlet_flow(N));
}

} // namespace

/// Returns the error by equations 3.5 to 3.8 for one link, written out.
double error_3_8(double compliance, const LinkSample& sample, const FlowConstants& flow) {
    double inlet = compliance * sample.inlet_slope_psi_per_s + sample.piston_flow_in3_per_s;
    double k = flow.orifice_in3_per_s_in2_sqrt_psi, drop = std::pow(inlet / (k * sample.inlet_in2), 2);
    double bypass = k * sample.bypass_in2 * std::sqrt(std::max(sample.inlet_psi + drop - flow.tank_psi, 0.0));
    return std::abs(flow.pump_in3_per_s - std::abs(inlet) - std::abs(bypass));
}

TEST_CASE("one junction has the error of equation 3.8") {
    std::mt19937 random(1);
    auto draw = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
    };
    for (int i = 0; i < 10'000; ++i) {
        LinkSample sample{draw(0, 3000), draw(-3000, 3000), draw(-100, 150), draw(0.001, 0.5), draw(0, 0.5)};
        double compliance = draw(0, 0.1);
        CHECK(error_of<1>(boom_alone, {compliance}, {sample}) ==
              doctest::Approx(error_3_8(compliance, sample, rounded_flow_constants())).epsilon(1e-9));
    }
}

TEST_CASE(
    "the error of eq. 3.8 agrees with a hand computation at spool .24 in, 1800 psi, 1500 psi/s, .5 in/s, C .0086") {
    OrificeAreas areas = boom_orifices(0.24);
    LinkSample sample{1800, 1500, 32 * 0.5, areas.inlet_in2, areas.bypass_in2};
    CHECK(std::abs(error_of<1>(boom_alone, {0.0086}, {sample}) - 2.0562) < 1e-4);
}

TEST_CASE("a pressure below the tank's gives no square root of a negative number") {
    // P = 10 psi is below the tank's 25: there is no bypass flow, and the error is all of 175.
    CHECK(error_of<1>(boom_alone, {0}, {steady(10, 0, 0.05, 0.05)}) == 175);
}

TEST_CASE("the error of two junctions is 0 at the solution of equations B.3 and B.4") {
    // k = 100, Q_t = 175, P_e = 25: a solution computed independently, to the digits given.
    LinkSample bucket = steady(2000, 56.7165, .1, .068), boom = steady(1700, 52.2247, .096, .016);
    CHECK(error_of<2>(bucket_and_boom, {0, 0}, {bucket, boom}) < 2e-3);

    SUBCASE("an additional flow into the boom's cylinder is missing at the junctions") {
        // More flow into the boom raises P_12, so that less flow passes the bucket and more flow goes to the tank: the
        // sum grows by more than the added flow.
        boom.piston_flow_in3_per_s += 1;
        double error = error_of<2>(bucket_and_boom, {0, 0}, {bucket, boom});
        CHECK(error > 1);
        CHECK(error < 3);
    }
    SUBCASE("a compliance counts in proportion to the slope of the pressure") {
        boom.inlet_slope_psi_per_s = 1000;
        boom.piston_flow_in3_per_s -= 8.6;
        CHECK(error_of<2>(bucket_and_boom, {0, 0.0086}, {bucket, boom}) < 2e-3);
        CHECK(error_of<2>(bucket_and_boom, {0, 0.0096}, {bucket, boom}) > 1);
    }
    SUBCASE("nothing flows through a bypass towards a higher pressure") {
        bucket.inlet_psi = 1000;
        double p12 = 1700 + std::pow(52.2247 / 9.6, 2), q12 = 100 * .016 * std::sqrt(p12 - 25);
        CHECK(error_of<2>(bucket_and_boom, {0, 0}, {bucket, boom}) ==
              doctest::Approx((175 - 56.7165) + (q12 + 52.2247)).epsilon(1e-9));
    }
}

TEST_CASE("a link alone with its pump takes the whole flow") {
    Circuit alone = circuit_of(Configuration::b, {Link::bucket});
    CHECK(error_of<1>(alone, {0}, {steady(2000, 175, .1, .3)}) == 0);
    CHECK(error_of<1>(alone, {0}, {steady(2000, 170, .1, .3)}) == 5);
}

TEST_CASE("in configuration d the boom gets the flow of both pumps") {
    Circuit both = circuit_of(Configuration::d, {Link::boom});
    double p = 1700 + std::pow(100 / 40.0, 2), past = 100 * .16 * std::sqrt(p - 25);
    CHECK(error_of<1>(both, {0}, {steady(1700, 100, .4, .16)}) == doctest::Approx(std::abs(350 - 100 - past)));
}

TEST_CASE("the errors of several compliances computed together equal separate errors, to the bit") {
    using Array = Lanes<2>;
    std::mt19937 random(2);
    auto draw = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
    };
    for (Configuration configuration : all_configurations)
        for (LinkSet group : coupled_groups(configuration)) {
            Circuit circuit = circuit_of(configuration, group);
            for (int i = 0; i < 1000; ++i) {
                std::array<LinkSample, 4> samples{};
                std::array<std::array<double, Array::count>, 4> drawn{};
                std::array<Array, 4> compliances;
                for (std::size_t j = 0; j < circuit.size(); ++j) {
                    samples[j] = {draw(0, 3000), draw(-3000, 3000), draw(-100, 150), draw(0.001, 0.5), draw(0, 0.5)};
                    for (double& compliance : drawn[j])
                        compliance = draw(0, 0.1);
                    compliances[j] = drawn[j];
                }
                auto together = circuit_error_in3_per_s<Array>(circuit, std::span<const Array>(compliances), samples,
                                                               fitted_flow_constants(), InletFlow::as_signed)
                                    .numbers();
                for (std::size_t n = 0; n < together.size(); ++n) {
                    std::array<double, 4> one{};
                    for (std::size_t j = 0; j < circuit.size(); ++j)
                        one[j] = drawn[j][n];
                    CHECK(circuit_error_in3_per_s<double>(circuit, std::span<const double>(one), samples,
                                                          fitted_flow_constants(),
                                                          InletFlow::as_signed) == together[n]);
                }
            }
        }
}

} // namespace placedpar
