#include "hydraulics/boom_record.hpp"
#include "runtime/random.hpp"

#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <stdexcept>

using namespace placedpar;

namespace {

const BoomScenario scenario;

std::vector<BoomMeasurement> exact_measurements() {
    return measure_boom(simulate_boom(scenario), scenario.machine.moment_arm_in, sampling_period_s, no_noise,
                        [] { return 0.0; });
}

} // namespace

TEST_CASE("scenario A has 20 usable samples from .20 to .58 s, the first 14 rising") {
    auto measured = exact_measurements();
    auto samples = usable_samples(measured, scenario.flow, scenario.machine);
    REQUIRE(samples.size() == 20);
    for (std::size_t i = 0; i < samples.size(); ++i)
        CHECK(samples[i].inlet_psi == measured[10 + i].inlet_psi); // measurement 10 is at .20 s
    for (std::size_t i = 0; i < samples.size(); ++i)
        CHECK((samples[i].inlet_slope_psi_per_s > 0) == (i < 14));
}

TEST_CASE("the piston's flow at each sample is that of the motion, up to the line fit") {
    auto motion = simulate_boom(scenario);
    auto samples = usable_samples(exact_measurements(), scenario.flow, scenario.machine);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        double exact = 32 * motion[400 + 40 * i].velocity_in_per_s;
        CHECK(std::abs(samples[i].piston_flow_in3_per_s - exact) < 1.5);
    }
}

TEST_CASE("samples where the check valve shuts later are left out") {
    auto measured = exact_measurements();
    measured[15].spool_in = 0.18;  // a glitch: inlet shut
    measured[16].spool_in = 0.195; // open, but the pump cannot reach the load
    auto samples = usable_samples(measured, scenario.flow, scenario.machine);
    REQUIRE(samples.size() == 20);
    CHECK(samples[4].inlet_psi == measured[14].inlet_psi);
    CHECK(samples[5].inlet_psi == measured[17].inlet_psi);
}

TEST_CASE("a record that ends early gives fewer samples, one at rest none") {
    auto measured = exact_measurements();
    std::span<const BoomMeasurement> all(measured);
    CHECK(usable_samples(all.first(20), scenario.flow, scenario.machine).size() == 8); // centres 10 ... 17
    CHECK(usable_samples(all.first(6), scenario.flow, scenario.machine).empty());
    CHECK(usable_samples({}, scenario.flow, scenario.machine).empty());
}

TEST_CASE("measurements at another period than stated are refused") {
    auto measured = exact_measurements();
    CHECK_THROWS_AS(usable_samples(measured, scenario.flow, scenario.machine, {}, 0.01), std::invalid_argument);
}

TEST_CASE("the record of scenario A at low noise: frozen, to the bit") {
    RandomStream random(1991, "sensors");
    auto record = boom_record(scenario, low_noise, [&] { return random.uniform(); });
    std::uint64_t hash = 0xcbf29ce484222325u; // FNV-1a over whole words
    for (const std::vector<double>& sample : record)
        for (double value : sample)
            hash = (hash ^ std::bit_cast<std::uint64_t>(value)) * 0x100000001b3u;
    CHECK(hash == 2472957930391119669u);
}
