#include "boom_records.hpp"
#include "hydraulics/circuit/boom_orifices.hpp"
#include "hydraulics/data/parameters.hpp"
#include "hydraulics/plant/measurement.hpp"
#include "identification/flags.hpp"
#include "identification/spike.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

using namespace placedpar;
using namespace placedpar::hydraulics;
using namespace placedpar::identification;

namespace {

/// Restricts the settings to the rising part of the transient, where an offset has the greatest effect.
IdentificationWay rising(IdentificationWay way) {
    way.usable.rising = true;
    return way;
}

/// Returns settings with an elite and Gray code, with which hardly any search misses the answer.
IdentificationWay careful_way() {
    IdentificationWay way = thesis_way();
    way.coding = Coding::gray;
    way.search.elite = 1;
    way.usable.skipped = 2;
    return way;
}

bool is_flagged(const Identified& identified, const std::string& word) {
    const auto& flags = identified.links.at(0).flags;
    return std::any_of(flags.begin(), flags.end(),
                       [&](const Flag& flag) { return flag.text.find(word) != std::string::npos; });
}

Record with_spool_offset(Record record, double offset_in) {
    for (double& spool : record.of(Link::boom, Sensor::spool))
        spool += offset_in;
    return record;
}

} // namespace

TEST_CASE("a good record raises no flag, whatever the seed") {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        Identified identified = identify_boom(boom_measured(1.5, low_noise, seed), careful_way(), seed);
        CAPTURE(seed);
        CHECK(!identified.flagged());
        for (const Flag& flag : identified.links[0].flags)
            FAIL_CHECK(flag.text);
    }
}

TEST_CASE("angles in radians flag the answer as uncertain, and a constant spool is flagged") {
    Record radians = boom_measured(1.5, low_noise, 1), stuck = radians;
    for (double& angle : radians.of(Link::boom, Sensor::angle))
        angle *= std::numbers::pi / 180;
    for (double& spool : stuck.of(Link::boom, Sensor::spool))
        spool = 0.25;
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        CHECK(is_flagged(identify_boom(radians, thesis_way(), seed), "uncertain"));
        CHECK(is_flagged(identify_boom(stuck, thesis_way(), seed),
                         "the valve reading never changes, but the pressure changes as if the valve moved"));
    }
}

TEST_CASE("a calibrated offset may be a leak and is flagged if it exceeds the sensor's resolution and three errors") {
    Identified identified = identify_boom(boom_measured(1.5, low_noise, 1), careful_way(), 1);
    auto flagged = [&](double offset_in, double error_in) {
        Identified copy = identified;
        flag_calibration(copy, {offset_in, error_in, 50}, 0.00024);
        return is_flagged(copy, "a leak looks the same");
    };
    CHECK(flagged(0.0045, 0.00015));
    CHECK(!flagged(0.0045, 0.0015));
    CHECK(!flagged(-0.0045, 0.00015));
    CHECK(!flagged(0.0002, 0));
}

TEST_CASE("a spool that reads .02 in too low flags the answer as at the lower bound") {
    int flagged = 0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        Record record = with_spool_offset(boom_measured(1.5, low_noise, seed), -0.02);
        flagged += is_flagged(identify_boom(record, rising(thesis_way()), seed), "at the lower bound");
        // Without the offset, the record is as good as any other.
        Identified cured = identify_boom(record, careful_way(), seed, -0.02);
        CHECK(error_percent(cured.links[0].compliance_in3_per_psi, 0.0086) < 10);
        CHECK(!is_flagged(cured, "at the lower bound"));
    }
    CHECK(flagged >= 18);
}

TEST_CASE("a compliance beyond the range is flagged as at the upper bound") {
    CHECK(is_flagged(identify_boom(boom_measured(3, no_noise, 1, 0.15), thesis_way(), 1), "at the upper bound"));
}

TEST_CASE("samples long after the transient are flagged as without excitation") {
    IdentificationWay way = thesis_way();
    way.usable.count = 150;
    CHECK(is_flagged(identify_boom(boom_measured(4, low_noise, 1), way, 1), "no excitation"));
}

TEST_CASE("impossible readings are flagged: pressures below vacuum, a frozen sensor, a piston that moves back as oil "
          "flows in") {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        Record good = boom_measured(1.5, low_noise, seed), negative = good, frozen = good, turned = good;
        for (double& psi : negative.of(Link::boom, Sensor::inlet_pressure))
            psi = -psi;
        auto& psi = frozen.of(Link::boom, Sensor::inlet_pressure);
        std::fill(psi.begin() + 16, psi.begin() + 26, psi[16]); // part of the rise
        for (double& angle : turned.of(Link::boom, Sensor::angle))
            angle = -angle;
        auto flagged = [&](const Record& record, FlagKind kind) {
            return identify_boom(record, thesis_way(), seed).links[0].flagged(kind);
        };
        CHECK(flagged(negative, FlagKind::vacuum));
        CHECK(flagged(frozen, FlagKind::frozen));
        CHECK(flagged(turned, FlagKind::falls));
    }
}

TEST_CASE("a pump with less flow than the model's is flagged as inconsistent") {
    ComplianceSearch prepared = prepare(boom_measured(1.5, low_noise, 1), Parameters::excavator(), {}, thesis_way());
    FlowConstants stronger = prepared.flow;
    stronger.pump_in3_per_s *= 1.5;
    CircuitProblem problem(prepared.problem.circuit(), stronger);
    CHECK(is_flagged(identify(problem, stronger, prepared.samples, thesis_way(), 1), "inconsistent"));
}

TEST_CASE("an answer is confirmed if it is within 10 % of least squares, with two standard errors added") {
    auto confirmed = [](double compliance, double least, double error) {
        return !unconfirmed_flag(compliance, {least, error}, "the whole movement");
    };
    CHECK(confirmed(0.0086, 0.0086, 0.0004));
    CHECK(confirmed(0.0080, 0.0086, 0.0001));
    CHECK(confirmed(0.0092, 0.0086, 0.0001));
    CHECK(!confirmed(0.0080, 0.0086, 0.0002));
    CHECK(!confirmed(0.0086, 0.0086, 0.0005));
    CHECK(!confirmed(0.0043, 0.0086, 0));
    constexpr double infinite = std::numeric_limits<double>::infinity();
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    for (auto [least, error] :
         {std::pair{0.0086, infinite}, {0.0086, none}, {none, 0.0}, {none, none}, {0.0, infinite}, {-0.0086, 0.0}})
        CHECK(!confirmed(0.0086, least, error));
}

TEST_CASE("no flag's text contains nan or inf") {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    for (double error : {infinite, none}) {
        for (const Flag& flag : {uncertain_flag(0.0086, error), *unconfirmed_flag(0.0086, {none, error}, "all")}) {
            CHECK(flag.text.find("nan") == std::string::npos);
            CHECK(flag.text.find("inf") == std::string::npos);
        }
    }
}

TEST_CASE("the noise of the worst sensors is not flagged as a spike, even in areas from the spool") {
    constexpr double deviations = 7.5;
    auto beyond_noise = [&](Sensor sensor, double noise) {
        CHECK(greatest_excursion(sensor, 0.02) >= deviations * noise);
    };
    beyond_noise(Sensor::inlet_pressure, high_noise.pressure_psi);
    beyond_noise(Sensor::angle, high_noise.angle_deg);
    beyond_noise(Sensor::spool, high_noise.spool_in);
    for (double spool_in = 0.15; spool_in < 0.45; spool_in += 0.01) {
        const OrificeAreas here = boom_orifices(spool_in), there = boom_orifices(spool_in + high_noise.spool_in);
        beyond_noise(Sensor::inlet_area, std::abs(there.inlet_in2 - here.inlet_in2));
        beyond_noise(Sensor::bypass_area, std::abs(there.bypass_in2 - here.bypass_in2));
    }
}

TEST_CASE("one or two outlying readings are a spike; a step or a ramp is not") {
    const double greatest = greatest_excursion(Sensor::inlet_pressure, 0.02);
    auto spike = [&](std::vector<double> five) { return is_spike(five, greatest); };
    CHECK(spike({500, 500, 600, 500, 500}));
    CHECK(spike({500, 500, -1e9, -1e9, 500}));
    CHECK(spike({500, 510, 1e9, 520, 530}));
    CHECK(!spike({500, 500, 570, 500, 500}));
    CHECK(!spike({500, 500, 2000, 2000, 2000}));
    CHECK(!spike({500, 900, 1300, 1700, 2100}));
    CHECK(!spike({500, 900, 1300, 0, 0})); // a log joined from two parts
    CHECK(!spike({0, 0, 1300, 900, 500}));
    CHECK(!spike({1e9, 500, 500, 500, 500}));
    CHECK(greatest_excursion(Sensor::inlet_pressure, 0.04) == 4 * greatest);
    CHECK(greatest_excursion(Sensor::inlet_pressure, 0.001) == greatest);
}
