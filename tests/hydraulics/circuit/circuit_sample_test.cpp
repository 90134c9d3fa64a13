#include "hydraulics/circuit/circuit_sample.hpp"
#include "hydraulics/circuit/voltage_spool.hpp"
#include "hydraulics/plant/excavator_record.hpp"
#include "hydraulics/plant/excavator_values.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace placedpar;
using namespace placedpar::hydraulics;

namespace {

const Circuit one_link = boom_circuit();

LinkCalibrations calibrations() { return boom_calibrations(single_boom_mechanics()); }

Record exact_record() {
    ExcavatorScenario scenario = single_boom_scenario();
    return measure_excavator(simulate_excavator(scenario), scenario, sampling_period_s, no_noise, [] { return 0.0; });
}

std::vector<CircuitSample> usable(const Record& record) {
    return usable_samples(circuit_samples(record, one_link, calibrations()), one_link, fitted_flow_constants());
}

/// Returns rows [first, last) of the record.
Record part(Record record, std::size_t first, std::size_t last) {
    auto cut = [&](std::vector<double>& values) {
        values = std::vector<double>(values.begin() + static_cast<std::ptrdiff_t>(first),
                                     values.begin() + static_cast<std::ptrdiff_t>(last));
    };
    cut(record.time_s);
    for (Sensor sensor : {Sensor::inlet_pressure, Sensor::angle, Sensor::spool})
        cut(record.of(Link::boom, sensor));
    return record;
}

} // namespace

TEST_CASE("scenario A has 20 usable samples from .20 to .58 s, the first 14 rising") {
    Record record = exact_record();
    auto samples = usable(record);
    REQUIRE(samples.size() == 20);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        CHECK(samples[i].index == 10 + i);
        CHECK(samples[i].time_s == doctest::Approx(0.20 + 0.02 * static_cast<double>(i)));
        CHECK(samples[i].links.at(0).inlet_psi == record.of(Link::boom, Sensor::inlet_pressure)[10 + i]);
        CHECK((samples[i].links.at(0).inlet_slope_psi_per_s > 0) == (i < 14));
    }
}

TEST_CASE("the piston's flow at each sample equals that of the motion, apart from the error of the line fit") {
    ExcavatorMotion motion = simulate_excavator(single_boom_scenario());
    auto samples = usable(exact_record());
    for (std::size_t i = 0; i < samples.size(); ++i) {
        double exact = 32 * motion.states[400 + 40 * i].links[0].velocity_in_per_s;
        CHECK(std::abs(samples[i].links.at(0).piston_flow_in3_per_s - exact) < 1.5);
    }
}

TEST_CASE("samples before a later closing of the check valve are left out") {
    Record record = exact_record();
    record.of(Link::boom, Sensor::spool)[15] = 0.18;  // a glitch: the inlet is shut
    record.of(Link::boom, Sensor::spool)[16] = 0.195; // open, but the pump's pressure is below the load's
    auto samples = usable(record);
    REQUIRE(samples.size() == 20);
    CHECK(samples[4].index == 14);
    CHECK(samples[5].index == 17);
}

TEST_CASE("a record that ends early gives fewer samples, and a record at rest none") {
    Record record = exact_record();
    CHECK(usable(part(record, 0, 20)).size() == 8); // centres 10 ... 17
    CHECK(usable(part(record, 0, 6)).empty());
}

TEST_CASE("no slope is computed across a gap") {
    Record record = exact_record();
    for (std::size_t i = 20; i < record.size(); ++i)
        record.time_s[i] += 0.1;
    auto samples = usable(record);
    REQUIRE(samples.size() == 20);
    CHECK(samples[7].index == 17); // samples 18 to 21 are within two samples of the gap
    CHECK(samples[8].index == 22);
}

TEST_CASE("the skipped samples are the first usable ones") {
    Record record = exact_record();
    UsableSamples rule;
    rule.skipped = 2;
    rule.count = 5;
    auto samples =
        usable_samples(circuit_samples(record, one_link, calibrations()), one_link, fitted_flow_constants(), rule);
    REQUIRE(samples.size() == 5);
    CHECK(samples[0].index == 12);
}

TEST_CASE("a spool that reads too high by an offset gives the areas of the true spool") {
    Record record = exact_record();
    for (double& spool : record.of(Link::boom, Sensor::spool))
        spool += 0.01;
    LinkCalibrations offset = calibrations();
    offset[index_of(Link::boom)].spool_offset_in = 0.01;
    auto mended = circuit_samples(record, one_link, offset);
    auto exact = circuit_samples(exact_record(), one_link, calibrations());
    for (std::size_t i = 0; i < exact.size(); ++i)
        CHECK(mended[i].links[0].bypass_in2 == doctest::Approx(exact[i].links[0].bypass_in2).epsilon(1e-12));
}

TEST_CASE("read areas are preferred to areas from the spool, and a missing channel is named") {
    Record record = exact_record();
    record.of(Link::boom, Sensor::inlet_area).assign(record.size(), 0.1);
    record.of(Link::boom, Sensor::bypass_area).assign(record.size(), 0.2);
    auto samples = circuit_samples(record, one_link, calibrations());
    CHECK(samples[0].links[0].inlet_in2 == 0.1);
    CHECK(samples[0].links[0].bypass_in2 == 0.2);
    record.of(Link::boom, Sensor::angle).clear();
    CHECK_THROWS_WITH_AS(circuit_samples(record, one_link, {}),
                         "the record has no channel boom.angle; it has boom.inlet_pressure, boom.spool, "
                         "boom.inlet_area, boom.bypass_area",
                         UnfitRecord);
}

TEST_CASE("in series, a link takes no flow while the other keeps the junction's pressure below the link's") {
    Circuit two = circuit_of(Configuration::a, {Link::bucket, Link::boom});
    // With k = 100, Q = 175, P_e = 25, these areas and pressures give 2032.168 psi at the bucket.
    std::array<LinkSample, 2> links{{{2000, 0, 0, .1, .068}, {1700, 0, 0, .096, .016}}};
    CHECK(all_open(two, links, rounded_flow_constants(), 0));
    links[0].inlet_psi = 2700;
    CHECK(!all_open(two, links, rounded_flow_constants(), 0));
    links[0].inlet_psi = 2000;
    links[1].inlet_in2 = 0;
    CHECK(!all_open(two, links, rounded_flow_constants(), 0));
}

TEST_CASE("the areas are computed from the voltage if no other reading exists") {
    Record record = exact_record();
    std::vector<double>& volts = record.of(Link::boom, Sensor::servo);
    const auto valve = std::get<SpoolOrifices>(single_boom_scenario().links[0].valve);
    const SpoolStep& step = valve.steps[0];
    for (double time_s : record.time_s) // the commanded step of scenario A
        volts.push_back(servo_volts(time_s >= step.time_s - 1e-9 ? step.desired_in : valve.rest_in));
    auto by_spool = circuit_samples(record, one_link, calibrations());
    record.of(Link::boom, Sensor::spool).clear();
    auto by_servo = circuit_samples(record, one_link, calibrations());
    REQUIRE(by_servo.size() == by_spool.size());
    for (std::size_t i = 0; i < by_servo.size(); ++i) // the lag of A.2 is exact for a held command
        CHECK(by_servo[i].links[0].bypass_in2 == doctest::Approx(by_spool[i].links[0].bypass_in2).epsilon(1e-5));
}
