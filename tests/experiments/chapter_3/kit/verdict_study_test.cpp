// Tests the on-line diagnosis of simulated machines, moved by an operator, with faults.

#include "experiments/chapter_3/kit/verdict_study.hpp"

#include "experiments/chapter_3/kit/rate_study.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <string>
#include <vector>

using namespace placedpar;
using namespace placedpar::hydraulics;
using namespace placedpar::identification;

namespace {

const RecordSource low_plant{"scenario-a", "low", false}, low_machine{"excavator", "low", true};

std::vector<TestedFault> called(const std::vector<TestedFault>& faults, AlarmKind kind) {
    std::vector<TestedFault> some;
    std::ranges::copy_if(faults, std::back_inserter(some),
                         [&](const TestedFault& each) { return each.called == kind; });
    return some;
}

/// Returns the readings of the boom's pressure in a movement.
std::vector<double> pressures(const SimulatedExcavator& digger, const PlantFault& fault, double compliance_factor,
                              std::uint64_t number) {
    return digger.movement(fault, compliance_factor, number).of(Link::boom, Sensor::inlet_pressure);
}

} // namespace

TEST_CASE("the tested faults depend on the valve's reading: a spool has an offset, a voltage a drift") {
    const auto by_spool = tested_faults(low_plant, AreasFrom::spool),
               by_voltage = tested_faults(low_machine, AreasFrom::servo),
               by_areas = tested_faults(low_plant, AreasFrom::areas);
    CHECK(called(by_spool, AlarmKind::offset).size() == 2); // in both directions
    CHECK(called(by_spool, AlarmKind::drift).empty());
    CHECK(called(by_voltage, AlarmKind::drift).size() == 2);
    CHECK(called(by_voltage, AlarmKind::offset).empty());
    CHECK(by_areas.size() == 5); // no offset, and no leak that begins
    for (const auto& faults : {by_spool, by_voltage, by_areas}) {
        std::set<std::string> names;
        for (const TestedFault& each : faults)
            CHECK(names.insert(each.fault.name).second);
        CHECK(std::ranges::count_if(faults, &TestedFault::from_first_day) == 2);
    }
}

TEST_CASE("a new leak and an offset may be undecided if no rest follows a movement") {
    for (const TestedFault& fault : tested_faults(low_plant, AreasFrom::spool)) {
        const bool begins_or_offset =
            fault.called == AlarmKind::offset || std::string(fault.fault.name).ends_with("that begins");
        CHECK_MESSAGE(fault.most_undecided.has_value() == !begins_or_offset, fault.fault.name);
    }
    for (const TestedFault& fault : tested_faults(low_machine, AreasFrom::spool))
        CHECK_MESSAGE(fault.most_undecided.has_value(), fault.fault.name);
}

TEST_CASE("a movement is determined by its number, and a machine by its seed") {
    const SimulatedExcavator digger(low_plant, AreasFrom::spool, 1), other(low_plant, AreasFrom::spool, 2);
    CHECK(pressures(digger, no_fault(), 1, 4) == pressures(digger, no_fault(), 1, 4));
    CHECK(pressures(digger, no_fault(), 1, 4) != pressures(digger, no_fault(), 1, 5));
    CHECK(pressures(digger, no_fault(), 1, 4) != pressures(other, no_fault(), 1, 4));
    CHECK(pressures(digger, no_fault(), 1.2, 4).size() == pressures(digger, no_fault(), 1, 4).size());
    CHECK(pressures(digger, no_fault(), 1.2, 4) != pressures(digger, no_fault(), 1, 4));
    CHECK(digger.links() == LinkSet{Link::boom});
}

TEST_CASE("a sample has the readings of its instant, by the control system's clock") {
    const SimulatedExcavator digger(low_machine, AreasFrom::servo, 1);
    const Record movement = digger.movement(no_fault(), 1, 1);
    const ExcavatorSample sample = digger.sample(movement, 10, 100);
    CHECK(sample.time_s == 100 + movement.time_s[10]);
    REQUIRE(sample.links[index_of(Link::boom)]);
    CHECK_FALSE(sample.links[index_of(Link::bucket)]);
    CHECK(sample.links[index_of(Link::boom)]->inlet_psi == movement.of(Link::boom, Sensor::inlet_pressure)[10]);
}

TEST_CASE("a logger of another rate reads the same movement more often") {
    RecordSource quick = low_plant;
    quick.period_s = logger_rates[1].period_s;
    const Record slow_record = SimulatedExcavator(low_plant, AreasFrom::spool, 1).movement(no_fault(), 1, 1),
                 quick_record = SimulatedExcavator(quick, AreasFrom::spool, 1).movement(no_fault(), 1, 1);
    CHECK(quick_record.size() == doctest::Approx(4 * static_cast<double>(slow_record.size())).epsilon(0.05));
    CHECK(quick_record.time_s.back() == doctest::Approx(slow_record.time_s.back()).epsilon(0.05));
}

TEST_CASE("a long movement takes twelve seconds, most of them steady") {
    const Record movement = SimulatedExcavator(low_plant, AreasFrom::spool, 1).movement(long_movement(low_plant), 1, 0);
    CHECK(movement.time_s.back() == doctest::Approx(12.1).epsilon(0.01));
    const std::vector<double>& psi = movement.of(Link::boom, Sensor::inlet_pressure);
    const auto [least, greatest] =
        std::minmax_element(psi.begin() + static_cast<std::ptrdiff_t>(psi.size() / 4), psi.end());
    CHECK(*greatest - *least < 0.15 * *greatest);
}

TEST_CASE("a sound machine has its baseline after few movements, and no alarm") {
    TestedMachine machine(low_plant, AreasFrom::spool, 7);
    const std::uint64_t next = make_known(machine);
    CHECK(next >= 3);
    CHECK(next < 10);
    CHECK(machine.alarms().empty());
    CHECK(watch(machine, {no_fault(), 1, {}}, 4, next).found_after == 0);
}

TEST_CASE("a compliance that grows by a half is found and named; watching one machine does not affect another") {
    TestedMachine machine(low_plant, AreasFrom::spool, 7);
    const std::uint64_t next = make_known(machine);
    const TestedFault softer{{"C +50 %", {}}, 1.5, AlarmKind::compliance};
    const Outcome outcome = watch(machine, softer, faulty_movements, next);
    CHECK(outcome.found_after >= 1);
    CHECK(outcome.called);
    CHECK_FALSE(outcome.undecided);
    CHECK(machine.alarms().empty());
    TestedFault miscalled = softer; // the expected alarm is another one
    miscalled.called = AlarmKind::leak;
    const Outcome other = watch(machine, miscalled, faulty_movements, next);
    CHECK(other.found_after == outcome.found_after);
    CHECK_FALSE(other.called);
}
