// Tests the statistics of studies of many searches, and how they depend on noise, samples and seeds.

#include "experiments/chapter_3/kit/boom_search.hpp"
#include "experiments/chapter_3/kit/study.hpp"
#include "experiments/kit/record_seeds.hpp"
#include "tests/nearly.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

using namespace placedpar;
using namespace placedpar::hydraulics;
using namespace placedpar::identification;

namespace {

const Seeds six_seeds{1, 2, 3, 4, 5, 6};

/// Returns the largest difference of a pressure from the same pressure without noise.
double scatter_psi(const MeasurementNoise& noise) {
    const Transients noisy = measure_transients(noise, {}, six_seeds),
                     clean = measure_transients(no_noise, {}, six_seeds);
    double greatest = 0;
    for (std::size_t i = 0; i < six_seeds.size(); ++i)
        for (const CircuitSample& sample : noisy.samples[i])
            for (const CircuitSample& same : clean.samples[i])
                if (same.index == sample.index)
                    greatest = std::max(greatest, std::abs(same.links[0].inlet_psi - sample.links[0].inlet_psi));
    return greatest;
}

} // namespace

TEST_CASE("a study of one search is that search") {
    SearchStudy study;
    study.error_percent = {7};
    CHECK(study.median_percent() == 7);
    CHECK(study.ninetieth_percent() == 7);
    CHECK(study.within_ten_percent() == 100);
}

TEST_CASE("an error of exactly ten percent is within ten percent") {
    SearchStudy study;
    study.error_percent = {10, 10.0001};
    CHECK(study.within_ten_percent() == 50);
    CHECK(study.median_percent() == 10);
    CHECK(study.ninetieth_percent() == 10.0001);
}

TEST_CASE("transients have the true compliance, and as many samples as the rule uses") {
    for (std::size_t count : {5u, 20u}) {
        const Transients transients = measure_transients(low_noise, {.count = count}, six_seeds);
        CHECK(transients.true_in3_per_psi == 0.0086);
        REQUIRE(transients.samples.size() == 6);
        for (const auto& samples : transients.samples)
            CHECK(samples.size() == count);
    }
}

TEST_CASE("more noise scatters the pressures more: by a few standard deviations of 2, 5 and 10 psi") {
    CHECK(scatter_psi(no_noise) == 0);
    // A sample's pressure is the middle of a line through five readings, with a deviation of 1 / sqrt(5) of one
    // reading.
    for (const MeasurementNoise& noise : {low_noise, mid_noise, high_noise}) {
        CHECK(scatter_psi(noise) > 1.5 * noise.pressure_psi / std::sqrt(5.0));
        CHECK(scatter_psi(noise) < 4.5 * noise.pressure_psi);
    }
}

TEST_CASE("a search errs more at high noise than without noise, and never by less than 0 %") {
    const auto errors = [](const MeasurementNoise& noise) {
        return study(measure_transients(noise, thesis_way().usable, six_seeds), thesis_way(), six_seeds);
    };
    const SearchStudy clean = errors(no_noise), noisy = errors(high_noise);
    CHECK(clean.median_percent() < 1.5); // the limit of the identification study
    CHECK(noisy.median_percent() > clean.median_percent());
    CHECK(std::ranges::min(noisy.error_percent) >= 0);
    for (double codes : noisy.si_codes)
        CHECK(codes <= 1); // the units do not change the best code
}

TEST_CASE("strings that are too long to be tried one by one have no best code") {
    IdentificationWay way = thesis_way();
    way.bits = 30;
    const Seeds one{1};
    const SearchStudy found = study(measure_transients(no_noise, way.usable, one), way, one);
    CHECK(found.error_percent.size() == 1);
    CHECK(found.codes_from_optimum.empty());
    CHECK(found.si_codes.empty());
}

TEST_CASE("least squares needs five usable samples") {
    const BoomData data = measure({BoomPlant::simple}, 1);
    const BoomModel model = model_of(data, AreasFrom::spool);
    CHECK_FALSE(least_squares_compliance(data, model, {.count = 4}));
    CHECK(least_squares_compliance(data, model, {.count = 5}).value() == test::nearly(0.0086, 0.1));
    CHECK_FALSE(least_squares_compliance(data, model, {.first_slope_psi_per_s = 1e9})); // no sample is usable
}

TEST_CASE("usable samples follow each other, begin as the pressure rises, and end when it falls if so asked") {
    const BoomData data = measure({BoomPlant::simple}, 1);
    const BoomModel model = model_of(data, AreasFrom::spool);
    const auto rising = usable_of(data, model, rising_way().usable), all = usable_of(data, model, {.count = 60});
    REQUIRE(rising.size() >= 5);
    CHECK(all.size() > rising.size());
    CHECK(rising.front().time_s == all.front().time_s);
    CHECK(rising.front().links[0].inlet_slope_psi_per_s >= 150);
    for (std::size_t i = 1; i < all.size(); ++i)
        CHECK(all[i].index == all[i - 1].index + 1);
    for (const CircuitSample& sample : rising)
        CHECK(sample.links[0].inlet_slope_psi_per_s > 0);
    CHECK(all[rising.size()].links[0].inlet_slope_psi_per_s <= 0); // the rule stopped there
}

TEST_CASE("the identified compliance follows the true one, from half to twice the machine's") {
    for (double factor : {0.5, 1.0, 2.0}) {
        BoomMotion motion{BoomPlant::simple};
        motion.inlet_compliance_in3_per_psi = factor * 0.0086;
        const BoomData data = measure(motion, 1);
        CHECK(data.boom.inlet_compliance_in3_per_psi == factor * 0.0086);
        const BoomIdentified found = identify_boom(data, model_of(data, AreasFrom::spool), rising_way(), 1);
        CHECK(found.least_squares.value() == test::nearly(factor * 0.0086, 0.05));
        CHECK(found.compliance_in3_per_psi == test::nearly(factor * 0.0086, 0.1));
        CHECK_FALSE(found.at_lower_bound);
    }
}

TEST_CASE("a motion's duration and spool are those that are asked for, and the slow motion rises more slowly") {
    BoomMotion motion{BoomPlant::simple}, slow = motion;
    motion.duration_s = 1;
    motion.spool_desired_in = 0.24;
    slow.slow = true;
    const BoomData data = measure(motion, 1), slower = measure(slow, 1);
    CHECK(data.record.time_s.back() == test::nearly(1, 0.03));
    CHECK(data.record.of(Link::boom, Sensor::spool).back() == test::nearly(0.24, 1e-3));
    const auto steepest = [](const BoomData& of) {
        double slope = 0;
        for (const CircuitSample& sample : samples_of(of, model_of(of, AreasFrom::spool)))
            slope = std::max(slope, sample.links[0].inlet_slope_psi_per_s);
        return slope;
    };
    CHECK(steepest(slower) < 0.6 * steepest(measure({BoomPlant::simple}, 1)));
}

TEST_CASE("both plants record both pressures, the angle, the spool and the voltage of the boom alone") {
    for (BoomPlant plant : {BoomPlant::simple, BoomPlant::measured}) {
        const BoomData data = measure({plant}, 1);
        for (Sensor sensor :
             {Sensor::inlet_pressure, Sensor::outlet_pressure, Sensor::angle, Sensor::spool, Sensor::servo})
            CHECK(data.record.of(Link::boom, sensor).size() == data.record.size());
        CHECK(data.record.links() == LinkSet{Link::boom});
        CHECK(data.record.period_s == sampling_period_s);
    }
}

TEST_CASE("the calibrations of a model have its source, its lag and its offset, for the boom") {
    const BoomData data = measure({BoomPlant::simple}, 1);
    const BoomModel model{AreasFrom::servo, 7.5, 0.003};
    const LinkCalibration boom = calibrations_of(data, model)[index_of(Link::boom)];
    CHECK(boom.from == AreasFrom::servo);
    CHECK(boom.constants.spool_lag_per_s == 7.5);
    CHECK(boom.spool_offset_in == 0.003);
    CHECK(model_of(data, AreasFrom::spool).spool_lag_per_s == 8); // a_0 of the machine
    CHECK(model_of(data, AreasFrom::spool).spool_offset_in == 0);
}
