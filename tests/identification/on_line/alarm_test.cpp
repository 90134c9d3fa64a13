#include "identification/on_line/alarm.hpp"

#include "identification/verdict/way_matrices.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace placedpar;
using namespace placedpar::hydraulics;
using namespace placedpar::identification;

namespace {

constexpr Link bu = Link::bucket, bo = Link::boom, sw = Link::swing;

LinkVerdict verdict_in(VerdictKind kind, double units = 1) {
    Deviation deviation{{units, units, units, units}, two_ways_of(WayMatrix::Identity() * 0.01)};
    return {{kind, 0.99, deviation, 3}, WayUnits::of(0.0086)};
}

std::vector<Alarm> alarms_of(const LinkVerdict& bucket, const LinkVerdict& boom, const LinkVerdict& swing = {}) {
    return find_alarms({bucket, boom, {}, swing});
}

} // namespace

TEST_CASE("sound links, and links without enough evidence, raise no alarm") {
    CHECK(find_alarms({}).empty());
    CHECK(alarms_of(verdict_in(VerdictKind::sound), verdict_in(VerdictKind::not_enough_evidence)).empty());
}

TEST_CASE("the alarm of one faulty link states the size and the part to check") {
    auto leak = alarms_of(verdict_in(VerdictKind::sound), verdict_in(VerdictKind::leak));
    REQUIRE(leak.size() == 1);
    CHECK(leak[0] == Alarm{AlarmKind::leak, {bo}, ""});
    CHECK(leak[0].text ==
          "boom: a leak of 0.0014 in^3/(s psi) (standard error 0.0001 in^3/(s psi)): check hose, cylinder and "
          "seals; 99 % sure, from 3 movements");
    CHECK(alarms_of({}, verdict_in(VerdictKind::compliance, -1))[0].text ==
          "boom: the compliance has changed by -20 % (standard error 2 %): a stiffer hose, or a partly closed line; "
          "99 % sure, from 3 movements");
    CHECK(alarms_of({}, verdict_in(VerdictKind::sensor))[0].text ==
          "boom: the readings are impossible: below vacuum, frozen, with wild single values, with a wrong sign or "
          "unit, or with a piston that moves although no oil can flow in: check the sensors");
}

TEST_CASE("equal faults of all links of a branch give one alarm about their shared parts") {
    auto same = alarms_of(verdict_in(VerdictKind::leak), verdict_in(VerdictKind::leak));
    REQUIRE(same.size() == 1);
    CHECK(same[0] == Alarm{AlarmKind::branch, {bu, bo}, ""});
    auto different = alarms_of(verdict_in(VerdictKind::leak), verdict_in(VerdictKind::compliance));
    CHECK(std::ranges::count(different, AlarmKind::branch, &Alarm::kind) == 0);
    CHECK(different.size() == 2);
    // Two sensors share no part, and neither do two branches.
    CHECK(alarms_of(verdict_in(VerdictKind::sensor), verdict_in(VerdictKind::sensor)).size() == 2);
    CHECK(alarms_of({}, verdict_in(VerdictKind::leak), verdict_in(VerdictKind::leak))[1].links == LinkSet{sw});
}
