#include "experiments/kit/bootstrap.hpp"
#include "tests/nearly.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace placedpar;

TEST_CASE("the interval of a median contains it, and narrows with more values") {
    std::vector<double> few, many;
    for (int i = 0; i < 1000; ++i) {
        double value = (i * 7919) % 1000;
        many.push_back(value);
        if (i < 20)
            few.push_back(value);
    }
    Interval of_few = median_interval(few), of_many = median_interval(many);
    CHECK(of_many.contains(499.5));
    CHECK(of_many.high - of_many.low < (of_few.high - of_few.low) / 2);
    CHECK(of_many.low == median_interval(many).low);
    CHECK(median_interval({3, 3, 3, 3, 3, 3}).low == 3);
    // The median of 1000 evenly spread values has a standard deviation of 500 / sqrt(1000): 31 to either side at 95 %.
    CHECK(of_many.high - of_many.low == doctest::Approx(62).epsilon(0.15));
}

TEST_CASE("five values bound neither a median nor a quotient with 95 %") {
    for (std::size_t runs : {0u, 1u, 5u}) {
        const std::vector<double> ones(runs, 1);
        CHECK(std::isinf(median_interval(ones).low));
        CHECK(std::isinf(median_interval(ones).high));
        CHECK(quotient_interval(ones, ones).contains(-1e300));
    }
    CHECK_FALSE(median_interval(std::vector<double>(6, 1)).contains(1.1));
}

TEST_CASE("the interval of a quotient of sums has width 0 if all runs are equal") {
    Interval same = quotient_interval({2, 4, 6, 2, 4, 6}, {1, 2, 3, 1, 2, 3});
    CHECK(same.low == 2);
    CHECK(same.high == 2);
    std::vector<double> above, below;
    for (int i = 0; i < 400; ++i) {
        above.push_back(i % 2 == 0 ? 4 : 2);
        below.push_back(3);
    }
    Interval around = quotient_interval(above, below);
    CHECK(around.contains(1));
    // The mean of 400 values of 4/3 or 2/3 has a standard deviation of 1/60, times 1.96 to either side.
    CHECK(around.high - around.low == test::nearly(2 * 1.96 / 60, 0.15));
}
