#include "identification/on_line/link_estimate.hpp"
#include "tests/nearly.hpp"

#include <doctest/doctest.h>

using namespace placedpar;
using namespace placedpar::identification;

namespace {

constexpr double step = 0.1 / 1024;

void add(LinkEstimate& estimate, double compliance, int times, double time_s = 1) {
    for (int i = 0; i < times; ++i)
        estimate.add(compliance, time_s, step, {});
}

} // namespace

TEST_CASE("nothing is known before the first generation") {
    LinkEstimate estimate;
    CHECK_FALSE(estimate.compliance_in3_per_psi());
    CHECK_FALSE(estimate.settled_in3_per_psi());
    CHECK_FALSE(estimate.lasting_in3_per_psi());
}

TEST_CASE("an estimate settles when the last 25 generations of one transient agree") {
    LinkEstimate estimate;
    estimate.excite(1000, {});
    add(estimate, 0.05, 5);
    add(estimate, 0.01, 24);
    CHECK(estimate.compliance_in3_per_psi() == 0.01);
    CHECK_FALSE(estimate.settled_in3_per_psi()); // one of the 25 is still .05
    add(estimate, 0.01, 1);
    CHECK(estimate.settled_in3_per_psi() == 0.01);
    estimate.excite(687, {}); // a slope of 687 psi/s into .01 in^3/psi is 6.87 in^3/s; 6.88 would be needed
    CHECK_FALSE(estimate.excited());
    CHECK(estimate.settled_in3_per_psi() == 0.01);
    estimate.excite(689, {});
    add(estimate, 0.0101, 24);
    CHECK(estimate.settled_in3_per_psi() == 0.01); // 24 estimates in this transient
    add(estimate, 0.0101, 1, 9);
    CHECK(estimate.settled_in3_per_psi() == 0.0101);
    CHECK(estimate.state().settled_in3_per_psi.size() == 2);
    CHECK(estimate.state().settled_time_s == 9);
    CHECK(estimate.lasting_in3_per_psi() == test::nearly(0.01005));
}

TEST_CASE("the last five transients are kept") {
    LinkEstimate estimate;
    for (int i = 1; i <= 7; ++i) {
        estimate.excite(1000, {});
        add(estimate, 0.001 * i, 60, 10.0 * i);
        estimate.end_transient();
    }
    CHECK(estimate.state().settled_in3_per_psi.size() == 5);
    CHECK(estimate.lasting_in3_per_psi() == test::nearly(0.005));
    CHECK(estimate.settled_in3_per_psi() == test::nearly(0.007));
}

TEST_CASE("interrupted excitation does not begin a new transient") {
    LinkEstimate estimate;
    for (int i = 1; i <= 4; ++i) {
        estimate.excite(1000, {});
        add(estimate, 0.001 * i, 60, 0.3 * i);
        estimate.end_transient();
    }
    CHECK(estimate.state().settled_in3_per_psi == std::vector<double>{0.004});
}

TEST_CASE("estimates at the bounds of the search are flagged") {
    CHECK(at_lower_bound(0, step));
    CHECK(at_lower_bound(2 * step, step));
    CHECK_FALSE(at_lower_bound(0.001, step));
    CHECK(at_upper_bound(0.1 - step, step));
    CHECK_FALSE(at_upper_bound(0.09, step));
}
