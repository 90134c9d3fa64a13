#include "experiments/kit/statistics.hpp"

#include <doctest/doctest.h>

using namespace placedpar;

TEST_CASE("percentage of a sample within a bound") { CHECK(percent_within({5, 1, 4, 2, 3}, 2) == 40); }

TEST_CASE("mean and deviation of a sample") {
    std::vector<double> values{2, 4, 4, 4, 5, 5, 7, 9};
    CHECK(mean(values) == 5);
    CHECK(deviation(values) == doctest::Approx(2.13809)); // sqrt(32 / 7)
}
