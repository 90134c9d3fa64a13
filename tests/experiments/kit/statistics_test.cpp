#include "experiments/kit/statistics.hpp"

#include <doctest/doctest.h>

using namespace placedpar;

TEST_CASE("percentage of a sample within a bound") { CHECK(percent_within({5, 1, 4, 2, 3}, 2) == 40); }

TEST_CASE("mean and deviation of a sample") {
    std::vector<double> values{2, 4, 4, 4, 5, 5, 7, 9};
    CHECK(mean(values) == 5);
    CHECK(deviation(values) == doctest::Approx(2.13809)); // sqrt(32 / 7)
}

TEST_CASE("the interval of a median is that of resampled medians") {
    std::vector<double> values;
    for (int i = 1; i <= 101; ++i)
        values.push_back(i);
    Interval interval = median_interval(values);
    CHECK(interval.median == 51);
    // By the binomial distribution of how many values lie below the median: about 10 places to either side.
    CHECK(interval.low == doctest::Approx(41).epsilon(0.05));
    CHECK(interval.high == doctest::Approx(61).epsilon(0.05));
    CHECK(median_interval({3, 3, 3}).low == 3);
    CHECK(median_interval({3, 3, 3}).high == 3);
}
