// Tests the data for the experiments of section 3.1: records of both plants.
#include "experiments/chapter_3/kit/boom_data.hpp"
#include "tests/nearly.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

using namespace placedpar;
using namespace placedpar::hydraulics;

namespace {

const std::vector<double>& of(const BoomData& data, Sensor sensor) { return data.record.of(Link::boom, sensor); }

double greatest_difference(const std::vector<double>& a, const std::vector<double>& b) {
    REQUIRE(a.size() == b.size());
    double greatest = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        greatest = std::max(greatest, std::abs(a[i] - b[i]));
    return greatest;
}

constexpr double spool_step_in = 1.0 / 4096; // of the measured machine's converter

} // namespace

TEST_CASE("a spool offset does not change the motion of the simple plant, only its readings and equation A.1") {
    BoomData right = measure({BoomPlant::simple}, 1), off = measure({BoomPlant::simple, no_noise, 0.01}, 1);
    CHECK(of(right, Sensor::inlet_pressure) == of(off, Sensor::inlet_pressure));
    CHECK(of(right, Sensor::angle) == of(off, Sensor::angle));
    for (AreasFrom from : {AreasFrom::spool, AreasFrom::servo}) {
        auto true_spool = spool_of(right, model_of(right, from)), believed = spool_of(off, model_of(off, from));
        for (std::size_t i = 0; i < believed.size(); ++i)
            CHECK(believed[i] - true_spool[i] == test::nearly(0.01));
        BoomModel cured = model_of(off, from);
        cured.spool_offset_in = 0.01;
        CHECK(greatest_difference(spool_of(off, cured), true_spool) < 1e-9);
    }
}

TEST_CASE("a spool offset changes the motion of the measured machine only by converter steps") {
    BoomData right = measure({BoomPlant::measured}, 1), off = measure({BoomPlant::measured, no_noise, 0.01}, 1);
    // One step of 20 V over 4096 is .0022 in of spool, and that is 2.5 in^3/s; of the pressure a few psi.
    CHECK(greatest_difference(of(right, Sensor::inlet_pressure), of(off, Sensor::inlet_pressure)) < 20);
    CHECK(greatest_difference(of(right, Sensor::spool), of(off, Sensor::spool)) == test::nearly(0.01, 0.25));
}

TEST_CASE("without noise the simple plant's spool follows from the voltage by the lag") {
    BoomData data = measure({BoomPlant::simple}, 1);
    CHECK(greatest_difference(spool_of(data, model_of(data, AreasFrom::servo)), of(data, Sensor::spool)) < 1e-6);
}

TEST_CASE("the measured machine's spool lags behind the lag model by its dead time") {
    BoomData data = measure({BoomPlant::measured}, 1);
    auto by_voltage = spool_of(data, model_of(data, AreasFrom::servo));
    // The first reading after the step is 20 ms late, and the spool has moved for 10 of them.
    const double step_in = 0.1296, lag_per_s = 8;
    const double expected_in = step_in * (std::exp(-lag_per_s * 0.010) - std::exp(-lag_per_s * 0.020)); // .0092
    CHECK(std::abs(greatest_difference(by_voltage, of(data, Sensor::spool)) - expected_in) < spool_step_in / 2);
}

TEST_CASE("many measurements are one motion, with the noise of each seed") {
    BoomMotion motion{BoomPlant::simple, low_noise};
    const std::vector<std::uint64_t> seeds{7, 18446744073709551615u, 9};
    auto many = measure(motion, seeds);
    REQUIRE(many.size() == 3);
    CHECK(of(many[2], Sensor::inlet_pressure) == of(measure(motion, 9), Sensor::inlet_pressure));
    CHECK(of(many[0], Sensor::inlet_pressure) != of(many[1], Sensor::inlet_pressure));
    CHECK(of(many[0], Sensor::servo) == of(many[1], Sensor::servo));
}

TEST_CASE("the model subtracts its assumed offset from the spool, so its inlet area is smaller") {
    const BoomData data = measure({BoomPlant::simple}, 1);
    const BoomModel right = model_of(data, AreasFrom::spool), offset{right.from, right.spool_lag_per_s, 0.01};
    const auto spool = spool_of(data, right), lower = spool_of(data, offset);
    for (std::size_t i = 0; i < spool.size(); ++i)
        CHECK(lower[i] == test::nearly(spool[i] - 0.01));
    const auto samples = samples_of(data, right), with_offset = samples_of(data, offset);
    REQUIRE(samples.size() == with_offset.size());
    std::size_t smaller = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        smaller += with_offset[i].links[0].inlet_in2 < samples[i].links[0].inlet_in2;
        CHECK(with_offset[i].links[0].inlet_in2 <= samples[i].links[0].inlet_in2);
        CHECK(with_offset[i].links[0].bypass_in2 >= samples[i].links[0].bypass_in2); // the bypass shuts as it opens
        CHECK(with_offset[i].links[0].inlet_psi == samples[i].links[0].inlet_psi);
    }
    CHECK(smaller > samples.size() / 4);
}
