#include "hydraulics/plant/excavator_record.hpp"
#include "hydraulics/plant/excavator_values.hpp"
#include "identification/compliance_fit.hpp"
#include "runtime/random.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>

using namespace placedpar;
using namespace placedpar::hydraulics;
using namespace placedpar::identification;

namespace {

std::vector<CircuitSample> samples_of(const MeasurementNoise& noise, std::uint64_t seed) {
    ExcavatorScenario scenario = single_boom_scenario();
    RandomStream random(seed, "sensors");
    Record record = measure_excavator(simulate_excavator(scenario), scenario, sampling_period_s, noise,
                                      [&] { return random.uniform(); });
    return usable_samples(circuit_samples(record, boom_circuit(), boom_calibrations(scenario.links[0].mechanics)),
                          boom_circuit(), scenario.flow);
}

const std::array<double, 1> far{0.03};

} // namespace

TEST_CASE("least squares finds the compliance of the motion without noise from a distant start") {
    auto fit = fit_compliances(boom_circuit(), samples_of(no_noise, 1), fitted_flow_constants(), far);
    REQUIRE(fit);
    CHECK(std::abs(fit->compliance_in3_per_psi[0] / 0.0086 - 1) < 0.02); // the error of the line fits remains
}

TEST_CASE("the standard error of least squares agrees with the scatter of the answers over seeds") {
    double sum = 0, squares = 0, stated = 0;
    constexpr int seeds = 100;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        auto fit = fit_compliances(boom_circuit(), samples_of(mid_noise, seed), fitted_flow_constants(), far);
        REQUIRE(fit);
        double compliance = fit->compliance_in3_per_psi[0];
        sum += compliance;
        squares += compliance * compliance;
        stated += fit->standard_error[0];
    }
    double scatter = std::sqrt((squares - sum * sum / seeds) / (seeds - 1));
    // The formula ignores that neighbouring slopes share readings, so it is right only roughly.
    CHECK(stated / seeds / scatter > 0.4);
    CHECK(stated / seeds / scatter < 2.5);
}

TEST_CASE("samples without a slope do not determine the compliance") {
    CircuitSample still{0, 0, {{1800, 0, 50, .08, .03}}};
    std::vector<CircuitSample> samples(10, still);
    auto fit = fit_compliances(boom_circuit(), samples, fitted_flow_constants(), far);
    CHECK((!fit || std::isinf(fit->standard_error[0])));
}

TEST_CASE("the exhaustive optimum is the best of all codes evaluated one by one") {
    auto samples = samples_of(mid_noise, 3);
    auto found = exhaustive_optimum(boom_circuit(), samples, fitted_flow_constants(), InletFlow::absolute, 6, 0.1, 400);
    double greatest = -1e300;
    std::uint64_t best = 0;
    for (std::uint64_t code = 0; code < 64; ++code) {
        std::array<double, 1> compliance{0.1 * static_cast<double>(code) / 64};
        double fitness = 0;
        for (const CircuitSample& sample : samples) {
            double error = circuit_error_in3_per_s<double>(boom_circuit(), std::span<const double>(compliance),
                                                           sample.links, fitted_flow_constants(), InletFlow::absolute);
            fitness += 400 - error * error;
        }
        if (fitness > greatest) {
            greatest = fitness;
            best = code;
        }
    }
    CHECK(found.codes == std::vector{best});
    CHECK(found.fitness == greatest);
}

TEST_CASE("the optimum of an exact sample is the true pair of codes") {
    // The two junctions of circuit_error_test.cpp, with slopes for which the compliances matter.
    Circuit two = circuit_of(Configuration::a, {Link::bucket, Link::boom});
    double unit = 0.1 / 16;
    CircuitSample sample{
        0, 0, {{2000, 1500, 56.7165 - 1500 * 3 * unit, .1, .068}, {1700, 900, 52.2247 - 900 * 5 * unit, .096, .016}}};
    std::vector<CircuitSample> window(10, sample);
    window[5].links[0].inlet_slope_psi_per_s = 500; // keeps flows and slopes from being proportional
    window[5].links[0].piston_flow_in3_per_s = 56.7165 - 500 * 3 * unit;
    auto found = exhaustive_optimum(two, window, rounded_flow_constants(), InletFlow::as_signed, 4, 0.1, 400);
    CHECK(found.codes == std::vector<std::uint64_t>{3, 5});
}
