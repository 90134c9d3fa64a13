#include "hydraulics/plant/measurement.hpp"
#include "runtime/random.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

using namespace placedpar;
using namespace placedpar::hydraulics;

namespace {

std::vector<double> boom(const Record& record, Sensor sensor) { return record.of(hydraulics::Link::boom, sensor); }

} // namespace

TEST_CASE("Box-Muller: known values, moments and tails") {
    std::array<double, 4> given{1 - std::exp(-0.5), 0, 1 - std::exp(-2), 0.5};
    std::size_t next = 0;
    UniformSource scripted = [&] { return given.at(next++); };
    CHECK(standard_normal(scripted) == doctest::Approx(1));
    CHECK(standard_normal(scripted) == doctest::Approx(-2));

    RandomStream random(5, "normal");
    UniformSource uniform = [&] { return random.uniform(); };
    constexpr int count = 100000;
    double sum = 0, squares = 0;
    int beyond_two = 0;
    for (int i = 0; i < count; ++i) {
        double value = standard_normal(uniform);
        sum += value;
        squares += value * value;
        beyond_two += std::abs(value) > 2;
    }
    CHECK(std::abs(sum / count) < 0.012);         // 3.8 standard errors
    CHECK(std::abs(squares / count - 1) < 0.017); // 3.8 standard errors
    CHECK(std::abs(beyond_two / double(count) - 0.0455) < 0.0025);
}

TEST_CASE("without noise the sensors tell the state, every 20 ms") {
    std::vector<BoomState> motion = simulate_boom(BoomScenario());
    UniformSource uniform = [] { return 0.25; };
    auto record = measure_boom(motion, 22.4, sampling_period_s, no_noise, uniform);
    REQUIRE(record.size() == 76); // 0 ... 1.5 s
    for (std::size_t i = 0; i < record.size(); ++i) {
        const BoomState& state = motion[40 * i];
        CHECK(record.time_s[i] == state.time_s);
        CHECK(std::abs(boom(record, Sensor::inlet_pressure)[i] - state.inlet_psi) <= pressure_resolution_psi / 2);
        CHECK(std::abs(boom(record, Sensor::spool)[i] - state.spool_in) <= spool_resolution_in / 2);
        CHECK(boom(record, Sensor::angle)[i] == doctest::Approx(state.piston_in / 22.4 * 180 / std::numbers::pi));
    }
}

TEST_CASE("the same seed gives the same record; noise scales with its level") {
    std::vector<BoomState> motion = simulate_boom(BoomScenario());
    auto measure = [&](std::uint64_t seed, const MeasurementNoise& noise) {
        RandomStream random(seed, "sensors");
        return boom(measure_boom(motion, 22.4, sampling_period_s, noise, [&] { return random.uniform(); }),
                    Sensor::inlet_pressure);
    };
    auto once_psi = measure(1, low_noise), again_psi = measure(1, low_noise), other_psi = measure(2, low_noise);
    auto five_psi = measure(1, mid_noise), none_psi = measure(1, no_noise);
    CHECK(once_psi[7] == again_psi[7]);
    CHECK(once_psi[7] != other_psi[7]);
    CHECK((five_psi[7] - none_psi[7]) / (once_psi[7] - none_psi[7]) == doctest::Approx(2.5).epsilon(1e-5));
}

TEST_CASE("a sampling period that is no multiple of the step is refused") {
    std::vector<BoomState> motion = simulate_boom(BoomScenario());
    CHECK_THROWS_AS(measure_boom(motion, 22.4, 0.00075, no_noise, [] { return 0.0; }), std::invalid_argument);
    CHECK_THROWS_AS(measure_boom({}, 22.4, 0.02, no_noise, [] { return 0.0; }), std::invalid_argument);
}
