// Tests how faults of the machine change the identified compliance.

#include "experiments/chapter_3/kit/fault_study.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace placedpar;
using namespace placedpar::hydraulics;

namespace {

const RecordSource quiet_plant{"scenario-a", "none", false}, quiet_machine{"excavator", "none", true};

/// Compares without doctest::Approx, which also allows an absolute error as large as a compliance.
bool is_near(double found, double known, double part) { return std::abs(found - known) <= part * std::abs(known); }

} // namespace

TEST_CASE("least squares over the rise finds the compliance of a sound machine and its doubled value") {
    const double sound = least_squares(record_of(no_fault(), quiet_plant, 1));
    CHECK(is_near(sound, 0.0086, 0.05));
    CHECK(is_near(least_squares(record_of(doubled_compliance(), quiet_plant, 1)), 2 * sound, 0.05));
}

TEST_CASE("a search agrees with least squares within its resolution plus a tenth") {
    for (const PlantFault& fault : {no_fault(), doubled_compliance()}) {
        const Record record = record_of(fault, quiet_plant, 1);
        CHECK(is_near(identified(record, AreasFrom::spool, 1), least_squares(record), 0.1));
        CHECK(search_faulty(record, AreasFrom::spool, 1).estimates.back().compliance_in3_per_psi[0] ==
              identified(record, AreasFrom::spool, 1));
    }
}

TEST_CASE("a leak increases the apparent compliance") {
    const double sound = least_squares(record_of(no_fault(), quiet_plant, 1)),
                 leaking = least_squares(record_of(leak_of("5 %", 0.0014), quiet_plant, 1)),
                 more = least_squares(record_of(leak_of("10 %", 0.0028), quiet_plant, 1));
    CHECK(leaking > 1.02 * sound);
    CHECK(is_near(more - sound, 2 * (leaking - sound), 0.2));
}

TEST_CASE("a drift of the servo-valve moves the boom and falsifies only answers from the voltage") {
    const Record right = record_of(no_fault(), quiet_machine, 1), drifted = record_of(drift_of(0.02), quiet_machine, 1);
    CHECK(right.of(Link::boom, Sensor::spool) != drifted.of(Link::boom, Sensor::spool));
    const double by_spool = identified(drifted, AreasFrom::spool, 1) / identified(right, AreasFrom::spool, 1),
                 by_voltage = identified(drifted, AreasFrom::servo, 1) / identified(right, AreasFrom::servo, 1);
    CHECK(is_near(by_spool, 1, 0.15));
    CHECK(std::abs(by_voltage - 1) > 2 * std::abs(by_spool - 1));
}

TEST_CASE("a seed determines only the noise") {
    const RecordSource noisy{"scenario-a", "mid", false};
    const Record one = record_of(no_fault(), noisy, 1), same = record_of(no_fault(), noisy, 1),
                 other = record_of(no_fault(), noisy, 2);
    CHECK(one.of(Link::boom, Sensor::inlet_pressure) == same.of(Link::boom, Sensor::inlet_pressure));
    CHECK(one.of(Link::boom, Sensor::inlet_pressure) != other.of(Link::boom, Sensor::inlet_pressure));
    CHECK(record_of(no_fault(), quiet_plant, 1).of(Link::boom, Sensor::angle) ==
          record_of(no_fault(), quiet_plant, 2).of(Link::boom, Sensor::angle));
}
