#include "text/statistics.hpp"

#include <doctest/doctest.h>

using namespace placedpar;

TEST_CASE("the median of an even number of values is the mean of the middle two") {
    CHECK(median({3}) == 3);
    CHECK(median({4, 1}) == 2.5);
    CHECK(median({9, 1, 5}) == 5);
    CHECK(median({4, 3, 2, 1}) == 2.5);
}

TEST_CASE("the lower median is one of the values") {
    CHECK(lower_median({3}) == 3);
    CHECK(lower_median({4, 1}) == 1);
    CHECK(lower_median({9, 1, 5}) == 5);
    CHECK(lower_median({4, 3, 2, 1}) == 2);
}

TEST_CASE("a quantile is one of the values, by nearest rank") {
    for (double share : {0.0, 0.5, 1.0})
        CHECK(quantile({7}, share) == 7);
    CHECK(quantile({5, 1, 4, 2, 3}, 0.9) == 5);
    CHECK(quantile({5, 1, 4, 2, 3}, 0.8) == 4);
    CHECK(quantile({5, 1, 4, 2, 3}, 0.5) == 3);
    CHECK(quantile({5, 1, 4, 2, 3}, 0) == 1);
}

TEST_CASE("the percentage of a sample within a bound is counted") { CHECK(percent_within({5, 1, 4, 2, 3}, 2) == 40); }

TEST_CASE("mean and standard deviation agree with a hand computation") {
    std::vector<double> values{2, 4, 4, 4, 5, 5, 7, 9};
    CHECK(mean(values) == 5);
    CHECK(deviation(values) == doctest::Approx(2.13809)); // sqrt(32 / 7)
}
