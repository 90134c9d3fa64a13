#include "../boom_records.hpp"
#include "hydraulics/plant/record_scenario.hpp"
#include "identification/on_line/record_diagnosis.hpp"
#include "tests/nearly.hpp"
#include "text/statistics.hpp"

#include <doctest/doctest.h>

#include <limits>

using namespace placedpar;
using namespace placedpar::hydraulics;
using namespace placedpar::identification;

namespace {

RecordDiagnosis diagnosis_of_boom(std::uint64_t seed, const DiagnosisSettings& settings = {}) {
    Diagnosis diagnosis("record", excavator_parameters(Parameters::excavator()), settings, seed);
    diagnosis.change({Configuration::a, {Link::boom}});
    return {std::move(diagnosis), settings, {}};
}

std::vector<MovementFinding> movements_of(const Record& record, std::uint64_t seed) {
    RecordDiagnosis diagnosis = diagnosis_of_boom(seed);
    std::vector<MovementFinding> found = diagnosis.take(record);
    for (MovementFinding& movement : diagnosis.end())
        found.push_back(std::move(movement));
    return found;
}

/// Returns the finding for the only link of the only movement.
LinkFinding boom_of(const Record& record, std::uint64_t seed) {
    auto found = movements_of(record, seed);
    REQUIRE(found.size() == 1);
    REQUIRE(found[0].links.size() == 1);
    return found[0].links[0];
}

Record piece_of(const Record& record, std::size_t first, std::size_t last) {
    Record piece;
    piece.period_s = record.period_s;
    auto cut = [&](const std::vector<double>& values) {
        return values.empty() ? values
                              : std::vector(values.begin() + static_cast<std::ptrdiff_t>(first),
                                            values.begin() + static_cast<std::ptrdiff_t>(last));
    };
    piece.time_s = cut(record.time_s);
    for (Sensor sensor : all_sensors)
        piece.of(Link::boom, sensor) = cut(record.of(Link::boom, sensor));
    return piece;
}

} // namespace

TEST_CASE("for 9 of 10 seeds a movement's compliance is within 6 % at low noise and 12 % at mid noise") {
    std::vector<double> low, mid;
    for (std::uint64_t seed = 1001; seed <= 1030; ++seed) {
        auto error = [&](const MeasurementNoise& noise) {
            return error_percent(boom_of(boom_measured(1.5, noise, seed), seed).compliance_in3_per_psi.value(), 0.0086);
        };
        low.push_back(error(low_noise));
        mid.push_back(error(mid_noise));
    }
    CHECK(quantile(low, 0.9) <= 6);
    CHECK(quantile(mid, 0.9) <= 12);
}

TEST_CASE("compliances from .0043 to .07 are found by the search and over the whole movement") {
    for (double truth : {0.0043, 0.0172, 0.0344, 0.07})
        for (std::uint64_t seed = 1001; seed <= 1005; ++seed) {
            const LinkFinding boom = boom_of(boom_measured(2.5, low_noise, seed, truth), seed);
            CAPTURE(truth);
            CHECK(error_percent(boom.compliance_in3_per_psi.value(), truth) < 10);
            REQUIRE(boom.whole);
            CHECK(error_percent(boom.whole->compliance_in3_per_psi, truth) < 10);
        }
}

TEST_CASE("the true compliance is within two standard errors in nine of ten movements") {
    int within = 0, whole_within = 0;
    for (std::uint64_t seed = 1001; seed <= 1040; ++seed) {
        const LinkFinding boom = boom_of(boom_measured(2, mid_noise, seed), seed);
        const double step = DiagnosisSettings().step_in3_per_psi();
        within += std::abs(*boom.compliance_in3_per_psi - 0.0086) <= 2 * boom.standard_error_in3_per_psi + step;
        const double unit = boom.whole->units.compliance_in3_per_psi;
        whole_within += std::abs(boom.whole->compliance_in3_per_psi - 0.0086) <=
                        2 * unit * boom.whole->deviation.standard_error(FaultHypothesis::compliance);
        CHECK(boom.standard_error_in3_per_psi < 0.25 * 0.0086);
    }
    CHECK(within >= 34);
    CHECK(whole_within >= 34);
}

TEST_CASE("a record in pieces gives the same answers as the whole record, to the bit") {
    const Record record = boom_measured(2.5, low_noise, 1001);
    const LinkFinding whole = boom_of(record, 7);
    for (std::size_t size : {1, 7, 50}) {
        RecordDiagnosis diagnosis = diagnosis_of_boom(7);
        std::vector<MovementFinding> found;
        for (std::size_t first = 0; first < record.size(); first += size)
            for (MovementFinding& movement :
                 diagnosis.take(piece_of(record, first, std::min(first + size, record.size()))))
                found.push_back(std::move(movement));
        for (MovementFinding& movement : diagnosis.end())
            found.push_back(std::move(movement));
        REQUIRE(found.size() == 1);
        CHECK(found[0].links[0].compliance_in3_per_psi == whole.compliance_in3_per_psi);
        CHECK(found[0].links[0].standard_error_in3_per_psi == whole.standard_error_in3_per_psi);
        CHECK(found[0].links[0].whole->deviation == whole.whole->deviation);
    }
}

TEST_CASE("a movement lasts from the valve's opening to its closing; a gap ends it") {
    Record record = boom_measured(2, low_noise, 1001);
    const auto one = movements_of(record, 1);
    REQUIRE(one.size() == 1);
    CHECK(one[0].from_s == test::nearly(0.2, 0.11));
    CHECK(one[0].to_s == doctest::Approx(record.time_s.back() - 2 * record.period_s));
    for (std::size_t i = 60; i < record.size(); ++i)
        record.time_s[i] += 1;
    const auto two = movements_of(record, 1);
    REQUIRE(two.size() == 2);
    CHECK(two[0].to_s == doctest::Approx(record.time_s[59] - 2 * record.period_s));
    CHECK(two[1].from_s > record.time_s[60]);
}

TEST_CASE(
    "a spool offset falsifies the search's answer, which is flagged; the fit to the whole movement finds the offset") {
    for (std::uint64_t seed = 1001; seed <= 1010; ++seed) {
        Record record = boom_measured(2, low_noise, seed);
        for (double& spool : record.of(Link::boom, Sensor::spool))
            spool -= 0.02;
        const LinkFinding boom = boom_of(record, seed);
        REQUIRE(boom.whole);
        CHECK(boom.whole->units.offset_in * boom.whole->deviation.by[2] == test::nearly(-0.02, 0.25));
        CHECK(error_percent(boom.whole->compliance_in3_per_psi, 0.0086) < 25);
        CHECK((!boom.flags.empty() || error_percent(boom.compliance_in3_per_psi.value_or(0), 0.0086) < 25));
    }
}

TEST_CASE("frozen angles, angles in radians and pressures in bar are sensor faults") {
    auto verdict_after = [](std::uint64_t seed, Sensor sensor, auto change) {
        RecordDiagnosis diagnosis = diagnosis_of_boom(seed);
        Record record = boom_measured(2, mid_noise, seed);
        for (double& reading : record.of(Link::boom, sensor))
            reading = change(reading);
        diagnosis.take(record);
        diagnosis.end();
        return diagnosis.diagnosis().verdict(Link::boom).verdict.kind;
    };
    for (std::uint64_t seed = 1001; seed <= 1010; ++seed) {
        CHECK(verdict_after(seed, Sensor::angle, [](double) { return 20.0; }) == VerdictKind::sensor);
        CHECK(verdict_after(seed, Sensor::angle, [](double deg) { return deg * 0.01745; }) == VerdictKind::sensor);
        CHECK(verdict_after(seed, Sensor::inlet_pressure, [](double psi) { return psi / 14.5; }) ==
              VerdictKind::sensor);
        CHECK(verdict_after(seed, Sensor::angle, [](double deg) { return deg; }) == VerdictKind::not_enough_evidence);
    }
}

TEST_CASE("flow into the compliance opens the gate, too, so a soft hose is followed for longer") {
    const ExcitationGate gate;
    CHECK(gate.opens(800, 0.0086));
    CHECK(!gate.opens(799, 0.0086));
    CHECK(gate.opens(400, 0.0172));
    CHECK(!gate.opens(399, 0.0172));
    CHECK(gate.opens(800, 0.001)); // for a stiff link the slope is enough
    CHECK(gate.opens(150, std::nullopt));
    CHECK(!gate.opens(149, std::nullopt));
}
