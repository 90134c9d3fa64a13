#include "experiments/kit/cells.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace placedpar;

TEST_CASE("percentage of a sample within a bound") { CHECK(percent_within({5, 1, 4, 2, 3}, 2) == 40); }

TEST_CASE("mean and deviation of a sample") {
    std::vector<double> values{2, 4, 4, 4, 5, 5, 7, 9};
    CHECK(mean(values) == 5);
    CHECK(deviation(values) == doctest::Approx(2.13809)); // sqrt(32 / 7)
}

TEST_CASE("a cell with a tolerance is judged, one without is not") {
    CHECK(judged_cell("C", "spool", "in^3/psi", 0.0086, 0.0090, 0.0005, 5).within_tolerance());
    CHECK_FALSE(judged_cell("C", "spool", "in^3/psi", 0.0086, 0.0092, 0.0005, 5).within_tolerance());
    CHECK(compared_cell("C", "spool", "in^3/psi", 0.0086, 0.0200, 5).within_tolerance());
}

TEST_CASE("a cell judged from one side has no other bound, whatever is known") {
    Cell known = compared_cell("share", "way", "%", 65, 52, 0);
    CHECK(at_least(51, known).within_tolerance());
    CHECK_FALSE(at_least(55, known).within_tolerance());
    CHECK(at_least(51, compared_cell("share", "way", "%", 65, 100, 0)).within_tolerance());
    CHECK(at_most(10, plain_cell("error", "state", "%", 9.9, 1)).within_tolerance());
    CHECK_FALSE(at_most(10, plain_cell("error", "state", "%", 10.1, 1)).within_tolerance());
    CHECK_FALSE(at_most(10, plain_cell("error", "state", "%", std::nan(""), 1)).within_tolerance());
}

TEST_CASE("how far two samples may be apart: three deviations of their difference") {
    CHECK(share_tolerance(50, 50) == doctest::Approx(30));                   // 3 sqrt(2 * .25 / 50)
    CHECK(share_tolerance(50, 200) == doctest::Approx(15));                  // four times the records, half of it
    CHECK(share_tolerance(100, 200) == doctest::Approx(2.97).epsilon(0.01)); // 3 sqrt(2 * .0098 * .9902 / 200)
    CHECK(share_tolerance(0, 200) == doctest::Approx(share_tolerance(100, 200)));
    CHECK(deviation_tolerance(0.00004, 50, 0.000005) ==
          doctest::Approx(0.0000221).epsilon(0.01)); // 3/7 and half a digit
}
