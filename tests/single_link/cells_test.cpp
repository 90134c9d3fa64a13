#include "app/single_link/cells.hpp"

#include <doctest/doctest.h>

using namespace placedpar;

TEST_CASE("shares of a sample") {
    std::vector<double> values{5, 1, 4, 2, 3};
    CHECK(median(values) == 3);
    CHECK(share_below(values, 0.9) == 5);
    CHECK(share_below(values, 0.8) == 4);
    CHECK(share_below(values, 0) == 1);
    CHECK(percent_within(values, 2) == 40);
}

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
