// Tests a gap in the record: no slope or window may span it, and the spool continues to move during the gap.
#include "boom_records.hpp"
#include "hydraulics/circuit/voltage_spool.hpp"

#include <doctest/doctest.h>

using namespace placedpar;
using namespace placedpar::hydraulics;
using namespace placedpar::identification;

namespace {

Record without(const Record& record, std::size_t first, std::size_t count) {
    Record rest;
    rest.period_s = record.period_s;
    for (std::size_t i = 0; i < record.size(); ++i) {
        if (i >= first && i < first + count)
            continue;
        rest.time_s.push_back(record.time_s[i]);
        for (Sensor sensor : all_sensors)
            if (record.has(Link::boom, sensor))
                rest.of(Link::boom, sensor).push_back(record.of(Link::boom, sensor)[i]);
    }
    return rest;
}

constexpr std::size_t first_lost = 20; // the transient begins at sample 10

/// A record of two hoses, the second after the gap. A window across the gap would fit neither.
Record two_hoses() {
    Record record = boom_measured(1.5, no_noise, 1), other = boom_measured(1.5, no_noise, 1, 0.02);
    for (std::size_t i = first_lost; i < record.size(); ++i)
        for (Sensor sensor : {Sensor::inlet_pressure, Sensor::angle, Sensor::spool})
            record.of(Link::boom, sensor)[i] = other.of(Link::boom, sensor)[i];
    return without(record, first_lost, 2);
}

} // namespace

TEST_CASE("a gap restarts the window") {
    IdentificationWay way = thesis_way();
    way.usable.count = 14; // the last ten samples would span the gap
    Identified identified = identify_boom(two_hoses(), way, 1);
    std::vector<std::size_t> after;
    for (const TransientEstimate& estimate : identified.estimates)
        if (estimate.index >= first_lost)
            after.push_back(estimate.index);
    REQUIRE(!after.empty());
    CHECK(after.front() == first_lost + 6); // two samples for the slope, then the fifth sample of the window
    REQUIRE(identified.links[0].optimum);
    CHECK(error_percent(*identified.links[0].optimum, 0.02) < 5);
    CHECK(error_percent(identified.estimates.back().compliance_in3_per_psi[0], 0.02) < 8);
}

TEST_CASE("samples on both sides of a gap do not count together for the first generation") {
    Record record = boom_measured(1.5, no_noise, 1);
    record = without(record, 41, record.size() - 41);
    for (std::size_t lost : {32u, 23u, 14u}) // eight samples between two gaps remain, with four slopes
        record = without(record, lost, 1);
    CHECK_THROWS_WITH_AS(identify_boom(record, thesis_way(), 1),
                         "4 usable samples without a gap, expected at least 5: the transient after the valve opens, in "
                         "which the pressure rises faster than 150 psi/s, is too short or missing",
                         UnfitRecord);
}

TEST_CASE("with areas from the voltage, samples lost before the transient do not change the answer") {
    // The voltage steps at 0.1 s, sample 5; the load check opens at sample 10.
    Record whole = boom_measured(1.5, no_noise, 1);
    for (double time_s : whole.time_s)
        whole.of(Link::boom, Sensor::servo).push_back(servo_volts(time_s < 0.0999 ? 0.1297 : 0.2593));
    auto estimates = [](const Record& record) {
        Question question{Configuration::a, {Link::boom}, {}, AreasFrom::servo};
        ComplianceSearch prepared = prepare(record, Parameters::excavator(), question, thesis_way());
        return identify(prepared.problem, prepared.flow, prepared.samples, thesis_way(), 1).links[0];
    };
    CHECK(error_percent(estimates(whole).compliance_in3_per_psi, 0.0086) < 3);
    CHECK(estimates(without(whole, 6, 2)).compliance_in3_per_psi == estimates(whole).compliance_in3_per_psi);
}
