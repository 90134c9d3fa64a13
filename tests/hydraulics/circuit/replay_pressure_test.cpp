#include "hydraulics/circuit/replay_pressure.hpp"
#include "hydraulics/plant/excavator_motion.hpp"
#include "hydraulics/plant/excavator_values.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

using namespace placedpar;
using namespace placedpar::hydraulics;

namespace {

/// Scenario A from .18 to .66 s, sampled every `steps` steps of .5 ms.
struct Recorded {
    std::vector<ReplaySample> samples;
    std::vector<double> pressures;
};

Recorded recorded(std::size_t stride) {
    auto motion = simulate_excavator(single_boom_scenario()).states;
    Recorded record;
    for (std::size_t i = 360; i <= 1320; i += stride) {
        const LinkState& boom = motion[i].links[0];
        record.samples.push_back({motion[i].time_s, boom.spool_in, boom.velocity_in_per_s});
        record.pressures.push_back(boom.inlet_psi);
    }
    return record;
}

struct Replay {
    double rms_psi, peak_psi;
};

Replay replay(double compliance_factor, std::size_t stride = 40) {
    Recorded record = recorded(stride);
    ReplayCircuit circuit{fitted_flow_constants(), 32, 0.0086 * compliance_factor};
    auto pressures = replay_pressure(record.samples, circuit, record.pressures[0], 0.0005);
    REQUIRE(pressures.size() == record.pressures.size());
    double sum = 0;
    for (std::size_t i = 0; i < pressures.size(); ++i)
        sum += std::pow(pressures[i] - record.pressures[i], 2);
    return {std::sqrt(sum / static_cast<double>(pressures.size())), *std::ranges::max_element(pressures)};
}

} // namespace

TEST_CASE("the true compliance reproduces the pressure of Figure 3.8; half of it and twice of it do not") {
    CHECK(replay(1).rms_psi < 4);
    CHECK(std::abs(replay(1).rms_psi - 1) < 0.5);
    CHECK(std::abs(replay(0.5).rms_psi - 134) < 2);
    CHECK(std::abs(replay(0.5).peak_psi - 2267) < 2);
    CHECK(std::abs(replay(2).rms_psi - 127) < 2);
    CHECK(std::abs(replay(2).peak_psi - 1883) < 2);
    CHECK(std::abs(replay(1.1).rms_psi - 19.5) < 0.5);
    CHECK(std::abs(replay(0.9).rms_psi - 19.5) < 0.5);
    CHECK(std::abs(replay(0.005 / 0.0086).rms_psi - 105) < 1); // the compliances of the two experiments
}

TEST_CASE("with a sample for every step the replayed pressure equals the simulation") {
    CHECK(replay(1, 1).rms_psi < 0.01);
}

TEST_CASE("with a shut inlet a resting piston keeps the pressure, and a moving one lowers it by A v t / C") {
    std::vector<ReplaySample> record{{0, 0.1, 0}, {0.1, 0.1, 0}, {0.2, 0.1, 0.5}, {0.3, 0.1, 0.5}};
    auto pressures = replay_pressure(record, {rounded_flow_constants(), 32, 0.0086}, 1500, 0.001);
    CHECK(pressures[0] == 1500);
    CHECK(pressures[1] == 1500);
    CHECK(pressures[2] == doctest::Approx(1500 - 32 * 0.025 / 0.0086));
    CHECK(pressures[3] == doctest::Approx(1500 - 32 * 0.075 / 0.0086));
    CHECK(replay_pressure({}, {rounded_flow_constants(), 32, 0.0086}, 1500, 0.001).empty());
}

TEST_CASE("an impossible replay is refused with the reason") {
    std::vector<ReplaySample> record{{0, 0.1, 0}, {0, 0.1, 0}};
    CHECK_THROWS_WITH_AS(replay_pressure(record, {rounded_flow_constants(), 32, 0.0086}, 1500, 0.001),
                         "sample 1 of the replay is at 0 s, expected a time after 0 s", std::invalid_argument);
    CHECK_THROWS_AS(replay_pressure(record, {rounded_flow_constants(), 32, 0}, 1500, 0.001), std::invalid_argument);
    CHECK_THROWS_AS(replay_pressure(record, {rounded_flow_constants(), 32, 0.0086}, 1500, 0), std::invalid_argument);
}
