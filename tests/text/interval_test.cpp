#include "text/interval.hpp"

#include <doctest/doctest.h>

using namespace placedpar;

TEST_CASE("intervals of a probability agree with published tables") {
    Interval none = success_interval(0, 20), half = success_interval(10, 20), all = success_interval(20, 20);
    CHECK(none.low == 0);
    CHECK(none.high == doctest::Approx(16.84).epsilon(0.001)); // Clopper and Pearson
    CHECK(half.low == doctest::Approx(27.20).epsilon(0.001));
    CHECK(half.high == doctest::Approx(72.80).epsilon(0.001));
    CHECK(all.low == doctest::Approx(83.16).epsilon(0.001));
    CHECK(all.high == 100);
    Interval gain = difference_interval(48, 80, 56, 70); // R. Newcombe 1998, method 10
    CHECK(gain.low == doctest::Approx(5.24).epsilon(0.002));
    CHECK(gain.high == doctest::Approx(33.39).epsilon(0.002));
    CHECK(difference_interval(5, 10, 5, 10).contains(0));
}
