// Tests simulated machines and the movements of their operators: what is drawn at random, and within which limits.

#include "experiments/chapter_3/kit/rate_study.hpp"
#include "experiments/chapter_3/kit/tested_machine.hpp"
#include "experiments/chapter_3/kit/verdict_study.hpp"
#include "hydraulics/data/parameters.hpp"
#include "tests/experiments/kit/replay_in_memory.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

using namespace placedpar;
using namespace placedpar::hydraulics;
using namespace placedpar::identification;

namespace {

const RecordSource quiet_simple{"scenario-a", "none", false}, quiet_servo{"excavator", "none", true},
    quiet_links{"links", "none", false};

Record movement_of(const RecordSource& source, AreasFrom from, std::uint64_t machine, std::uint64_t number) {
    return SimulatedExcavator(source, from, machine).movement(no_fault(), 1, number);
}

} // namespace

TEST_CASE("movements differ in their length, which is between 1.1 and 2.6 s without a servo-valve") {
    double shortest = 100, longest = 0;
    for (std::uint64_t number = 0; number < 40; ++number) {
        const double end_s = movement_of(quiet_simple, AreasFrom::spool, 1, number).time_s.back();
        shortest = std::min(shortest, end_s);
        longest = std::max(longest, end_s);
    }
    CHECK(shortest >= 1.05);
    CHECK(shortest < 1.4);
    CHECK(longest <= 2.6);
    CHECK(longest > 2.3);
}

TEST_CASE("the valve opens for 60 to 140 % of the thesis's flow: its spool ends between .24 and .28 in") {
    double least = 1, most = 0;
    for (std::uint64_t number = 0; number < 40; ++number) {
        const Record movement = movement_of(quiet_simple, AreasFrom::spool, 1, number);
        const double spool_in = movement.of(Link::boom, Sensor::spool).back();
        least = std::min(least, spool_in);
        most = std::max(most, spool_in);
        CHECK(movement.of(Link::boom, Sensor::spool).front() == doctest::Approx(0.1297).epsilon(0.001)); // at rest
    }
    CHECK(least >= 0.235);
    CHECK(least < 0.248);
    CHECK(most <= 0.2801);
    CHECK(most > 0.272);
}

TEST_CASE("with a servo-valve a movement also ends at rest: the angle stands still, and the spool is back") {
    for (std::uint64_t number : {0u, 1u, 2u}) {
        const Record movement = movement_of(quiet_servo, AreasFrom::servo, 1, number);
        const std::vector<double>&angle = movement.of(Link::boom, Sensor::angle),
              &spool = movement.of(Link::boom, Sensor::spool);
        CHECK(angle.back() == doctest::Approx(angle[angle.size() - 5]).epsilon(0.001));
        CHECK(spool.back() < spool[spool.size() / 2] - 0.05);
        CHECK(std::abs(angle.back() - angle.front()) > 1); // degrees; it has moved
    }
}

TEST_CASE("machines differ in their load by up to 10 %, and in a movement by 5 % more") {
    const double own = movement_of(quiet_simple, AreasFrom::spool, 1, 0).of(Link::boom, Sensor::inlet_pressure).front();
    std::vector<double> at_rest;
    for (std::uint64_t machine = 1; machine <= 30; ++machine)
        at_rest.push_back(
            movement_of(quiet_simple, AreasFrom::spool, machine, 0).of(Link::boom, Sensor::inlet_pressure).front());
    const auto [least, most] = std::ranges::minmax(at_rest);
    CHECK(most / least > 1.08); // the load carries nearly all of the pressure at rest
    CHECK(most / least < 1.15 / 0.85);
    CHECK(std::ranges::count(at_rest, own) == 1);
}

TEST_CASE("two links move by the scenario for several links, and their samples have both") {
    const SimulatedExcavator digger(quiet_links, AreasFrom::areas, 1);
    CHECK(digger.links() == LinkSet{Link::bucket, Link::boom});
    CHECK(digger.period_s() == 0.02);
    const Record movement = digger.movement(no_fault(), 1, 1);
    const ExcavatorSample sample = digger.sample(movement, 20, 7);
    CHECK(sample.time_s == 7 + movement.time_s[20]);
    for (Link link : {Link::bucket, Link::boom}) {
        const auto& reading = sample.links[index_of(link)];
        REQUIRE(reading);
        REQUIRE(std::holds_alternative<ValveAreas>(reading->valve));
        CHECK(std::get<ValveAreas>(reading->valve).inlet_in2 == movement.of(link, Sensor::inlet_area)[20]);
    }
    CHECK_FALSE(sample.links[index_of(Link::stick)]);
}

TEST_CASE("a sample has the valve's reading that the diagnosis asks for") {
    const auto valve = [](AreasFrom from) {
        const SimulatedExcavator digger(quiet_servo, from, 1);
        return digger.sample(digger.movement(no_fault(), 1, 1), 30, 0).links[index_of(Link::boom)]->valve;
    };
    CHECK(std::holds_alternative<SpoolPosition>(valve(AreasFrom::spool)));
    CHECK(std::holds_alternative<ServoVoltage>(valve(AreasFrom::servo)));
}

TEST_CASE("a machine without a servo-valve has no voltage, and only the scenario of several links measures areas") {
    CHECK_THROWS_WITH_AS(SimulatedExcavator(quiet_simple, AreasFrom::servo, 1),
                         "scenario-a does not record the voltage of a valve", std::invalid_argument);
    CHECK_THROWS_WITH_AS(SimulatedExcavator(quiet_servo, AreasFrom::areas, 1),
                         "excavator does not record the areas of a valve", std::invalid_argument);
    CHECK_THROWS_WITH_AS(SimulatedExcavator(quiet_links, AreasFrom::spool, 1),
                         "links does not record the spool of a valve", std::invalid_argument);
    CHECK_FALSE(movement_of(quiet_links, AreasFrom::areas, 1, 1).has(Link::boom, Sensor::spool));
    CHECK_FALSE(movement_of(quiet_simple, AreasFrom::spool, 1, 1).has(Link::boom, Sensor::inlet_area));
}

TEST_CASE("a fault's parameters replace the machine's own, and the factor multiplies its own compliance") {
    const SimulatedExcavator digger(quiet_simple, AreasFrom::spool, 1);
    const auto rise = [&](const PlantFault& fault, double factor) {
        const Record movement = digger.movement(fault, factor, 2);
        const std::vector<double>& psi = movement.of(Link::boom, Sensor::inlet_pressure);
        return std::ranges::max(psi) - psi.front();
    };
    CHECK(rise(no_fault(), 0.5) > rise(no_fault(), 1)); // a stiffer line overshoots
    CHECK(rise(no_fault(), 2) < rise(no_fault(), 1));
    const auto turned_deg = [&](const PlantFault& fault) {
        const std::vector<double> angle = digger.movement(fault, 1, 2).of(Link::boom, Sensor::angle);
        return std::abs(angle.back() - angle.front());
    };
    CHECK(turned_deg(leak_of("a large leak", 0.01)) < 0.9 * turned_deg(no_fault())); // oil that leaks moves no piston
}

TEST_CASE("a drift of the servo-valve moves its spool, and a fault has a name for each table") {
    const SimulatedExcavator digger(quiet_servo, AreasFrom::servo, 1);
    const auto spool_in_the_middle = [&](const PlantFault& fault) {
        const Record movement = digger.movement(fault, 1, 2);
        return movement.of(Link::boom, Sensor::spool)[movement.size() / 2];
    };
    // By equation A.1, 20 mV move the spool by about .01 in.
    CHECK(spool_in_the_middle(drift_of(0.02)) - spool_in_the_middle(no_fault()) == doctest::Approx(0.01).epsilon(0.3));
    CHECK(std::string(no_fault().name) == "sound");
    CHECK(doubled_compliance().parameters.front().second == 2 * Parameters::excavator()["boom.inlet_compliance"]);
    CHECK(leak_of("x", 0.0014).parameters.size() == 2); // the leak and the time at which it begins
}

TEST_CASE("a tested machine rests between its movements, so time passes and alarms stay") {
    TestedMachine machine({"scenario-a", "low", false}, AreasFrom::spool, 7);
    CHECK(machine.alarms().empty());
    const TestedFault doubled{{"C doubled", {}}, 2, AlarmKind::compliance, true};
    const Outcome outcome = watch(machine, doubled, faulty_movements, 0);
    REQUIRE(outcome.found_after > 0);
    CHECK(machine.alarms().empty()); // watch() moves a copy
    for (std::uint64_t number = 1; number <= outcome.found_after; ++number) {
        CHECK(machine.alarms().empty());
        machine.move(doubled.fault, 2, number);
    }
    REQUIRE(machine.alarms().size() >= 1);
    CHECK(machine.alarms().front() == Alarm{AlarmKind::compliance, {Link::boom}, {}});
}

TEST_CASE("a machine that is not watched is not found faulty, and a sound one has no alarm to call") {
    TestedMachine machine({"scenario-a", "low", false}, AreasFrom::spool, 7);
    const Outcome none = watch(machine, {{"C doubled", {}}, 2, AlarmKind::compliance}, 0, 0);
    CHECK(none.found_after == 0);
    CHECK_FALSE(none.called);
    CHECK_FALSE(none.undecided);
}

TEST_CASE("verdicts have a share of sound machines with an alarm, and of each fault found, for three noises") {
    test::ReplayInMemory replay(1);
    const RecordSource source{"links", "low", false};
    const Comparison table = verdict_comparison(replay.context, "two links", source, AreasFrom::areas);
    CHECK(table.judged);
    CHECK(table.name == "on-line verdicts: two links by areas, 1 machines of each kind");
    for (const char* noise : {"low noise", "mid noise", "high noise"}) {
        CHECK(std::ranges::count(replay.told, "two links by areas, " + std::string(noise) + ": 0 of 1 seeds") >= 1);
        CHECK(std::ranges::any_of(table.cells, [&](const Cell& cell) {
            return cell.column == noise && cell.row == "sound machines with an alarm" && cell.at_most == 1.0;
        }));
    }
    for (const TestedFault& fault : tested_faults(source, AreasFrom::areas)) {
        const std::vector<Cell> found = test::row_named(table, fault.fault.name + std::string(": found"));
        REQUIRE(found.size() == 3);
        for (const Cell& cell : found)
            CHECK((cell.simulated == 0 || cell.simulated == 100)); // one machine
        const std::vector<Cell> limits = test::row_named(table, fault.fault.name + std::string(": limit by theory"));
        CHECK(limits.size() == (fault.from_first_day ? 0 : 3));
        for (const Cell& limit : limits) {
            CHECK(limit.simulated >= 1); // even a test that knows nothing finds the 1 % that it accuses
            CHECK(limit.simulated <= 100);
        }
    }
}
