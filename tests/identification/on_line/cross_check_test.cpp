#include "identification/on_line/cross_check.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <initializer_list>

using namespace placedpar;
using namespace placedpar::hydraulics;
using namespace placedpar::identification;

namespace {

constexpr Link bu = Link::bucket, bo = Link::boom, st = Link::stick, sw = Link::swing;

/// A link of baseline .01 of which these sets say these multiples, each over three transients.
LinkCheck check_of(std::initializer_list<std::pair<LinkSet, double>> ratios) {
    LinkCheck check{0.01, {}};
    double time_s = 0;
    for (auto [set, ratio] : ratios)
        check.estimates.push_back({set, 0.01 * ratio, 0.01 * ratio, 3, ++time_s});
    return check;
}

std::vector<Alarm> alarms_of(const LinkCheck& bucket, const LinkCheck& boom, const LinkCheck& stick,
                             const LinkCheck& swing) {
    return find_alarms({bucket, boom, stick, swing}, {});
}

bool has(const std::vector<Alarm>& alarms, AlarmKind kind, LinkSet links) {
    return std::ranges::count(alarms, Alarm{kind, links, ""}) == 1;
}

} // namespace

TEST_CASE("a healthy excavator raises nothing") {
    CHECK(alarms_of({}, {}, {}, {}).empty());
    CHECK(alarms_of(check_of({{{bu}, 1.0}, {{bu, bo}, 1.1}}), check_of({{{bo}, 0.95}, {{bu, bo}, 1.05}}),
                    check_of({{{st}, 1}}), check_of({{{sw}, 1.11}}))
              .empty());
}

TEST_CASE("one link off in all its sets, the rest of its branch good: that link") {
    auto leak = alarms_of(check_of({{{bu}, 1}}), check_of({{{bo}, 1.2}, {{bu, bo}, 1.24}}), {}, {});
    REQUIRE(leak.size() == 1);
    CHECK(has(leak, AlarmKind::leak, {bo}));
    CHECK(leak[0].text.find("boom is off by +22 %") == 0);
    auto fault = alarms_of(check_of({{{bu}, 1}}), check_of({{{bo}, 1.6}, {{bu, bo}, 1.5}}), {}, {});
    REQUIRE(fault.size() == 1);
    CHECK(has(fault, AlarmKind::link_fault, {bo}));
    auto low = alarms_of(check_of({{{bu}, 1}}), check_of({{{bo}, 0.6}}), {}, {});
    CHECK(has(low, AlarmKind::link_fault, {bo}));
}

TEST_CASE("off in one of its sets only: no fault is located") {
    CHECK(alarms_of(check_of({{{bu}, 1}}), check_of({{{bo}, 1.0}, {{bu, bo}, 1.25}}), {}, {}).empty());
    // Up in one, down in the other.
    CHECK(alarms_of(check_of({{{bu}, 1}}), check_of({{{bo}, 0.87}, {{bu, bo}, 1.13}}), {}, {}).empty());
}

TEST_CASE("off in fewer transients than it takes: no fault is located") {
    LinkCheck young = check_of({{{bo}, 1.3}});
    young.estimates[0].transients = 2;
    CHECK(alarms_of(check_of({{{bu}, 1}}), young, {}, {}).empty());
}

TEST_CASE("all links of a branch off: what they share") {
    auto alarms =
        alarms_of(check_of({{{bu}, 1.3}}), check_of({{{bo}, 1.2}}), check_of({{{st}, 1}}), check_of({{{sw}, 1}}));
    REQUIRE(alarms.size() == 1);
    CHECK(has(alarms, AlarmKind::branch_fault, {bu, bo}));
    CHECK(has(alarms_of({}, {}, check_of({{{st}, 0.7}}), check_of({{{sw}, 0.8}})), AlarmKind::branch_fault, {st, sw}));
}

TEST_CASE("doubled, by the newest estimate") {
    CHECK(has(alarms_of({}, check_of({{{bu, bo}, 1}, {{bo}, 1.8}}), {}, {}), AlarmKind::doubled, {bo}));
    CHECK_FALSE(has(alarms_of({}, check_of({{{bo}, 1.8}, {{bu, bo}, 1}}), {}, {}), AlarmKind::doubled, {bo}));
    CHECK_FALSE(has(alarms_of({}, check_of({{{bo}, 1.79}}), {}, {}), AlarmKind::doubled, {bo}));
    LinkCheck no_baseline = check_of({{{bo}, 5}});
    no_baseline.baseline_in3_per_psi.reset();
    CHECK(alarms_of({}, no_baseline, {}, {}).empty());
}

TEST_CASE("spread over the sets") {
    CHECK(check_of({}).spread() == 0);
    CHECK(check_of({{{bo}, 2}}).spread() == 0);
    CHECK(check_of({{{bo}, 1}, {{bu, bo}, 1.5}, {{bo, sw}, 1.2}}).spread() == doctest::Approx(0.5 / 1.2));
    CHECK(has(alarms_of({}, check_of({{{bo}, 1}, {{bu, bo}, 1.36}}), {}, {}), AlarmKind::inconsistent, {bo}));
    CHECK_FALSE(has(alarms_of({}, check_of({{{bo}, 1}, {{bu, bo}, 1.34}}), {}, {}), AlarmKind::inconsistent, {bo}));
}

TEST_CASE("at the lower bound: drift") {
    LinkCheck check = check_of({{{bo}, 0.01}});
    check.at_lower_bound = true;
    CHECK(has(alarms_of({}, check, {}, {}), AlarmKind::drift, {bo}));
}
