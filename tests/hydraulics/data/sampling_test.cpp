#include "hydraulics/data/sampling.hpp"

#include <doctest/doctest.h>

using namespace placedpar;
using namespace placedpar::hydraulics;

namespace {

Record counted_record(std::size_t size, double period_s) {
    Record record;
    record.period_s = period_s;
    for (std::size_t i = 0; i < size; ++i) {
        record.time_s.push_back(static_cast<double>(i) * period_s);
        record.of(Link::boom, Sensor::inlet_pressure).push_back(static_cast<double>(i));
        record.of(Link::boom, Sensor::servo).push_back(static_cast<double>(i));
    }
    return record;
}

} // namespace

TEST_CASE("samples are as near to 20 ms apart as whole numbers of readings allow, from 10 Hz to 10 kHz") {
    CHECK(Sampling::of(0.0001).readings == 200);
    CHECK(Sampling::of(0.001).readings == 20);
    CHECK(Sampling::of(0.02).readings == 1);
    CHECK(Sampling::of(1 / 60.0).readings == 1);
    CHECK(Sampling::of(1 / 130.0).readings == 3);
    CHECK(Sampling::of(0.1).readings == 1);
    for (double hertz = 37.6; hertz <= 10'000; hertz *= 1.003) {
        const double period_s = Sampling::of(1 / hertz).period_s();
        CHECK(period_s > method_period_s * 2 / 3);
        CHECK(period_s < method_period_s * 4 / 3);
    }
    CHECK(Sampling::of(0.001).samples_in(4) == 200);
    CHECK(Sampling::of(0.1).samples_in(0.01) == 1);
}

TEST_CASE("slower and faster readings are refused with the reason") {
    CHECK_THROWS_WITH_AS(Sampling::of(0.11),
                         "the readings are 0.11 s apart, expected at most 0.1 s: slower readings do not show a "
                         "transient, which lasts some tenths of a second",
                         UnfitRecord);
    CHECK_THROWS_WITH_AS(Sampling::of(0.00005),
                         "the readings are 5e-05 s apart, expected at least 0.0001 s (10 kHz): average them first, or "
                         "check the time unit",
                         UnfitRecord);
}

TEST_CASE("a sample averages all its readings at their middle time; a voltage holds until the next sample") {
    const Record samples = averaged(counted_record(100, 0.005), Sampling::of(0.005));
    REQUIRE(samples.size() == 25);
    CHECK(samples.period_s == doctest::Approx(0.02));
    CHECK(samples.time_s[0] == doctest::Approx(0.0075));
    CHECK(samples.of(Link::boom, Sensor::inlet_pressure)[0] == 1.5);
    CHECK(samples.of(Link::boom, Sensor::servo)[0] == 3.5);
    CHECK(samples.of(Link::boom, Sensor::inlet_pressure)[24] == 97.5);
    CHECK(samples.of(Link::boom, Sensor::servo)[24] == 97.5); // the last sample has no successor
    CHECK(print_sampling(Sampling::of(0.005)) == "200 Hz averaged to 50 Hz, 4 readings each");
    CHECK(print_sampling(Sampling::of(0.001)) == "1 kHz averaged to 50 Hz, 20 readings each");
}

TEST_CASE("a sample has the configuration at the middle of its readings") {
    Record record = counted_record(12, 0.005);
    CHECK(averaged(record, Sampling::of(0.005)).configuration.empty());
    record.configuration = "aaddddeeeead";
    CHECK(averaged(record, Sampling::of(0.005)).configuration == "dea");
}

TEST_CASE("no sample reaches over a gap") {
    Record record = counted_record(10, 0.005);
    for (std::size_t i = 5; i < 10; ++i)
        record.time_s[i] += 0.1;
    const Record samples = averaged(record, Sampling::of(0.005));
    CHECK(samples.of(Link::boom, Sensor::inlet_pressure) == std::vector<double>{1.5, 6.5});
}
