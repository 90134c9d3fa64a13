#include "report/cell.hpp"
#include "tests/nearly.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace placedpar;

TEST_CASE("a cell with a tolerance is judged, a cell without a tolerance is not") {
    CHECK(judged_cell("C", "spool", "in^3/psi", 0.0086, 0.0090, 0.0005, 5).within_tolerance());
    CHECK_FALSE(judged_cell("C", "spool", "in^3/psi", 0.0086, 0.0092, 0.0005, 5).within_tolerance());
    CHECK(compared_cell("C", "spool", "in^3/psi", 0.0086, 0.0200, 5).within_tolerance());
}

TEST_CASE("a one-sided cell has one bound, even with a known figure") {
    Cell known = compared_cell("share", "way", "%", 65, 52, 0);
    CHECK(at_least(51, known).within_tolerance());
    CHECK_FALSE(at_least(55, known).within_tolerance());
    CHECK(at_least(51, compared_cell("share", "way", "%", 65, 100, 0)).within_tolerance());
    CHECK(at_most(10, plain_cell("error", "state", "%", 9.9, 1)).within_tolerance());
    CHECK_FALSE(at_most(10, plain_cell("error", "state", "%", 10.1, 1)).within_tolerance());
    CHECK_FALSE(at_most(10, plain_cell("error", "state", "%", std::nan(""), 1)).within_tolerance());
}

TEST_CASE("a share misses a bound only if its whole interval does, for few runs and many") {
    CHECK(share_cell("found", "low", 7, 12).simulated == doctest::Approx(100.0 * 7 / 12));
    CHECK(share_cell("found", "low", 7, 12).interval->contains(58));
    CHECK_FALSE(at_least(90, share_cell("found", "low", 7, 12)).within_tolerance()); // 27.7 to 84.8 %
    CHECK(at_least(90, share_cell("found", "low", 9, 12)).within_tolerance());       // 42.8 to 94.5 %
    CHECK(at_most(1, share_cell("alarms", "low", 1, 12)).within_tolerance());        // .2 to 38.5 %
    CHECK_FALSE(at_most(1, share_cell("alarms", "low", 2, 12)).within_tolerance());  // 2.1 to 48.4 %
    CHECK(at_most(1, share_cell("alarms", "low", 2, 200)).within_tolerance());
    CHECK_FALSE(at_most(1, share_cell("alarms", "low", 17, 200)).within_tolerance()); // about the same share as 1 of 12
    CHECK_FALSE(at_least(90, share_cell("found", "low", 150, 200)).within_tolerance());
    for (std::size_t runs : {12, 50, 200, 1000}) { // a share that meets the bound always meets it; a share far below
                                                   // the bound never does
        CHECK(at_least(90, share_cell("found", "low", runs * 9 / 10, runs)).within_tolerance());
        CHECK_FALSE(at_least(90, share_cell("found", "low", runs / 2, runs)).within_tolerance());
    }
}

TEST_CASE("a share of no runs has no value") {
    CHECK(at_least(95, share_cell("called", "low", 0, 0)).within_tolerance());
    CHECK(share_cell("called", "low", 0, 0).simulated == 0);
}

TEST_CASE("two samples may differ by four standard deviations of their difference") {
    CHECK(share_tolerance(50, 50) == doctest::Approx(40));  // 4 sqrt(2 * .25 / 50)
    CHECK(share_tolerance(50, 200) == doctest::Approx(20)); // 200 records instead of 50 halve the tolerance
    CHECK(share_tolerance(100, 200) == doctest::Approx(3.96).epsilon(0.01)); // 4 sqrt(2 * .0098 * .9902 / 200)
    CHECK(share_tolerance(0, 200) == doctest::Approx(share_tolerance(100, 200)));
    CHECK(deviation_tolerance(0.00004, 50, 0.000005) == test::nearly(0.00004 * 4 / 7 + 0.000005)); // plus half a digit
    CHECK(mean_tolerance(0.00014, 49, 0.00001) == test::nearly(0.00009));                          // 4/7 plus the bias
}

TEST_CASE("an error in percent needs a figure and a reference; a reference of 0 allows only 0") {
    CHECK(compared_cell("x", "a", "", -50, -40, 0).error_percent() == 20.0); // above the reference, whatever its sign
    CHECK(compared_cell("x", "a", "", 0, 0, 0).error_percent() == 0.0);
    CHECK_FALSE(compared_cell("x", "a", "", 0, 1e-9, 0).error_percent());
    CHECK_FALSE(compared_cell("x", "a", "", 5, std::nan(""), 0).error_percent());
    CHECK_FALSE(plain_cell("x", "a", "", 5, 0).error_percent());
    CHECK_FALSE(judged_cell("x", "a", "", 5, std::nan(""), 100, 0).within_tolerance());
}

TEST_CASE("a tolerance without a known figure does not judge") {
    CHECK(cell_of("x", "a", "", 3.0, 4, 0.5, 0).is_judged());
    CHECK_FALSE(cell_of("x", "a", "", {}, 4, 0.5, 0).is_judged());
    CHECK(cell_of("x", "a", "", {}, 4, 0.5, 0).within_tolerance());
}
