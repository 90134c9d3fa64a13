#include "hydraulics/plant/boom_sensors.hpp"
#include "hydraulics/plant/requirement.hpp"
#include "runtime/random.hpp"
#include "tests/nearly.hpp"
#include "text/statistics.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

using namespace placedpar;
using namespace placedpar::hydraulics;

namespace {

Record read_with(const BoomSensors& sensors, const MeasuredExcavator& excavator,
                 const std::vector<MeasuredState>& motion, std::uint64_t seed = 1) {
    RandomStream random(seed, "sensors");
    return read_boom_sensors(motion, excavator, sensors, [&] { return random.uniform(); });
}

} // namespace

TEST_CASE("a converter rounds to its steps, with an error of at most half a step") {
    Converter resolver{360, 16};
    CHECK(resolver.step() == 0.0054931640625);
    CHECK(Converter{360, 12}.step() == 0.087890625);
    CHECK(Converter{5000, 12}.step() == 1.220703125);
    for (double value = -20; value < 60; value += 0.0137) {
        CHECK(std::abs(resolver(value) - value) <= resolver.step() / 2);
        CHECK(std::remainder(resolver(value), resolver.step()) == 0);
    }
    Converter pressure{5000, 12}, whole{5000, 0};
    CHECK(pressure.limited(-3, 0) == 0);
    CHECK(pressure.limited(7000, 0) == 5000 - 1.220703125);
    CHECK(whole(1234.5678) == 1234.5678);
}

TEST_CASE("bits are whole numbers from 0 to 32") {
    Parameters parameters = Parameters::excavator();
    CHECK(bits_of(parameters, "sensors.resolver_bits") == 16);
    for (double wrong : {-1.0, 33.0, 12.5, std::nan(""), 1e300}) {
        parameters.set("sensors.resolver_bits", wrong);
        CHECK_THROWS_AS(bits_of(parameters, "sensors.resolver_bits"), UnfitScenario);
    }
}

TEST_CASE("without noise the readings are within half a converter step of the state") {
    MeasuredExcavator excavator = measured_excavator();
    excavator.duration_s = 1;
    std::vector<MeasuredState> motion = simulate_measured_excavator(excavator);
    for (int resolver_bits : {12, 16}) {
        BoomSensors sensors = boom_sensors();
        sensors.noise = no_noise;
        sensors.resolver.bits = resolver_bits;
        sensors.spool_offset_in = 0.01;
        Record record = read_with(sensors, excavator, motion);
        REQUIRE(record.size() == 51);
        double angle_step = resolver_bits == 12 ? 0.0879 : 0.0055;
        for (std::size_t i = 0; i < record.size(); ++i) {
            const MeasuredState& state = motion[200 * i];
            double angle = 20 + state.piston_in / 22.4 * 180 / std::numbers::pi;
            CHECK(record.time_s[i] == doctest::Approx(state.time_s));
            CHECK(std::abs(record.of(Link::boom, Sensor::inlet_pressure)[i] - state.inlet_psi) <= 0.6104);
            CHECK(std::abs(record.of(Link::boom, Sensor::outlet_pressure)[i] - state.outlet_psi) <= 0.6104);
            CHECK(std::abs(record.of(Link::boom, Sensor::angle)[i] - angle) <= angle_step / 2);
            CHECK(std::abs(record.of(Link::boom, Sensor::spool)[i] - (state.spool_in + 0.01)) <= 0.5 / 4096);
            CHECK(record.of(Link::boom, Sensor::servo)[i] == held_volts(excavator, record.time_s[i]));
        }
    }
}

TEST_CASE("noise has the requested standard deviation and depends on the seed") {
    MeasuredExcavator excavator = measured_excavator();
    excavator.command.desired_volts = 0; // the boom stands still
    excavator.duration_s = 30;
    excavator.integration_step_s = 2e-4;
    std::vector<MeasuredState> motion = simulate_measured_excavator(excavator);
    BoomSensors sensors = boom_sensors();
    sensors.noise = {10, 0.02, 0.001};
    auto deviation = [&](Sensor sensor) {
        double squares = 0, count = 0;
        for (std::uint64_t seed = 1; seed <= 20; ++seed) {
            Record record = read_with(sensors, excavator, motion, seed);
            const std::vector<double>& read = record.of(Link::boom, sensor);
            const double middle = mean(read);
            for (double value : read)
                squares += (value - middle) * (value - middle);
            count += static_cast<double>(read.size());
        }
        return std::sqrt(squares / count);
    };
    // The standard deviation of 30,020 samples must be within 1.6 %, which is four times 1 / sqrt(2 * 30,020). A
    // converter adds its step / sqrt(12).
    auto expected = [](double noise, const Converter& converter) {
        return std::hypot(noise, converter.step() / std::sqrt(12));
    };
    CHECK(deviation(Sensor::inlet_pressure) == test::nearly(expected(10, sensors.pressure), 0.016));
    CHECK(deviation(Sensor::angle) == test::nearly(expected(0.02, sensors.resolver), 0.016));
    CHECK(deviation(Sensor::spool) == test::nearly(expected(0.001, sensors.spool), 0.016));
    Record record = read_with(sensors, excavator, motion);
    Record again = read_with(sensors, excavator, motion), other = read_with(sensors, excavator, motion, 2);
    for (Sensor sensor : {Sensor::inlet_pressure, Sensor::angle, Sensor::spool}) {
        CHECK(again.of(Link::boom, sensor) == record.of(Link::boom, sensor));
        CHECK(other.of(Link::boom, sensor) != record.of(Link::boom, sensor));
    }
}

TEST_CASE("a period that is not a multiple of the step is refused") {
    MeasuredExcavator excavator = measured_excavator();
    excavator.duration_s = 0.1;
    std::vector<MeasuredState> motion = simulate_measured_excavator(excavator);
    BoomSensors sensors = boom_sensors();
    sensors.period_s = 0.00015;
    CHECK_THROWS_AS(read_with(sensors, excavator, motion), UnfitScenario);
}
