#include "experiments/kit/statistics.hpp"

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
