#include "hydraulics/plant/excavator_record.hpp"
#include "hydraulics/plant/excavator_values.hpp"
#include "hydraulics/plant/requirement.hpp"
#include "runtime/random.hpp"

#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

using namespace placedpar;
using namespace placedpar::hydraulics;

namespace {

std::vector<double> boom(const Record& record, Sensor sensor) { return record.of(Link::boom, sensor); }

} // namespace

TEST_CASE("without noise the readings are the state every 20 ms") {
    const ExcavatorScenario scenario = single_boom_scenario();
    const ExcavatorMotion motion = simulate_excavator(scenario);
    UniformSource uniform = [] { return 0.25; };
    auto record = measure_excavator(motion, scenario, sampling_period_s, no_noise, uniform);
    REQUIRE(record.size() == 76); // 0 ... 1.5 s
    for (std::size_t i = 0; i < record.size(); ++i) {
        const LinkState& state = motion.states[40 * i].links[0];
        CHECK(record.time_s[i] == motion.states[40 * i].time_s);
        CHECK(std::abs(boom(record, Sensor::inlet_pressure)[i] - state.inlet_psi) <= pressure_resolution_psi / 2);
        CHECK(std::abs(boom(record, Sensor::spool)[i] - state.spool_in) <= spool_resolution_in / 2);
        CHECK(boom(record, Sensor::angle)[i] == doctest::Approx(state.piston_in / 22.4 * 180 / std::numbers::pi));
    }
}

TEST_CASE("the same seed gives the same record; noise scales with its level") {
    const ExcavatorScenario scenario = single_boom_scenario();
    const ExcavatorMotion motion = simulate_excavator(scenario);
    auto measure = [&](std::uint64_t seed, const MeasurementNoise& noise) {
        RandomStream random(seed, "sensors");
        return boom(measure_excavator(motion, scenario, sampling_period_s, noise, [&] { return random.uniform(); }),
                    Sensor::inlet_pressure);
    };
    auto once_psi = measure(1, low_noise), again_psi = measure(1, low_noise), other_psi = measure(2, low_noise);
    auto five_psi = measure(1, mid_noise), none_psi = measure(1, no_noise);
    CHECK(once_psi[7] == again_psi[7]);
    CHECK(once_psi[7] != other_psi[7]);
    CHECK((five_psi[7] - none_psi[7]) / (once_psi[7] - none_psi[7]) == doctest::Approx(2.5).epsilon(1e-5));
}

TEST_CASE("a sampling period that is not a multiple of the step is refused") {
    const ExcavatorScenario scenario = single_boom_scenario();
    const ExcavatorMotion motion = simulate_excavator(scenario);
    CHECK_THROWS_AS(measure_excavator(motion, scenario, 0.00075, no_noise, [] { return 0.0; }), UnfitScenario);
    CHECK_THROWS_AS(measure_excavator({}, scenario, 0.02, no_noise, [] { return 0.0; }), UnfitScenario);
}

TEST_CASE("the record has the spool of links with a spool, and the areas of the others") {
    auto measured = [](ExcavatorScenario scenario) {
        scenario.duration_s = 0.1;
        return measure_excavator(simulate_excavator(scenario), scenario, sampling_period_s, low_noise,
                                 [] { return 0.5; });
    };
    Record spool = measured(single_boom_scenario()), areas = measured(two_link_scenario());
    CHECK(spool.has(Link::boom, Sensor::spool));
    CHECK(!spool.has(Link::boom, Sensor::inlet_area));
    for (Link link : {Link::bucket, Link::boom}) {
        CHECK(!areas.has(link, Sensor::spool));
        CHECK(areas.has(link, Sensor::inlet_area));
        CHECK(areas.has(link, Sensor::bypass_area));
    }
}

TEST_CASE("the record of scenario A at low noise is unchanged to the bit") {
    RandomStream random(1991, "sensors");
    auto record = boom_record(single_boom_scenario(), low_noise, [&] { return random.uniform(); });
    std::uint64_t hash = 0xcbf29ce484222325u; // FNV-1a over whole words
    for (const std::vector<double>& sample : record)
        for (double value : sample)
            hash = (hash ^ std::bit_cast<std::uint64_t>(value)) * 0x100000001b3u;
    CHECK(hash == 6244623149285955010u);
}
