#include "hydraulics/circuit/line_fit.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

using namespace placedpar;
using namespace placedpar::hydraulics;

TEST_CASE("the centred line has the derivative of any quadratic") {
    constexpr double period_s = 0.02;
    std::vector<double> values;
    for (int i = 0; i < 12; ++i)
        values.push_back(1600 + 800 * i * period_s - 3000 * i * i * period_s * period_s);
    CentredLineFit fit(period_s);
    for (std::size_t i = 2; i < 10; ++i)
        CHECK(fit.slope_per_s(values, i) == doctest::Approx(800 - 6000 * static_cast<double>(i) * period_s));
}

TEST_CASE("the weights are -2 -1 0 1 2 over 10 T, and white noise is amplified 15.811 times") {
    CentredLineFit fit(0.02);
    double gain_squared = 0;
    for (std::size_t i = 0; i < 5; ++i) {
        std::array<double, 5> impulse{};
        impulse.at(i) = 1;
        double weight = fit.slope_per_s(impulse, 2);
        CHECK(weight == doctest::Approx((static_cast<double>(i) - 2) / 0.2));
        gain_squared += weight * weight;
    }
    CHECK(std::sqrt(gain_squared) == doctest::Approx(15.811).epsilon(1e-4));
}

TEST_CASE("only samples with two neighbours on either side have a slope") {
    CHECK_FALSE(CentredLineFit::has_slope(5, 1));
    CHECK(CentredLineFit::has_slope(5, 2));
    CHECK_FALSE(CentredLineFit::has_slope(5, 3));
    CHECK_FALSE(CentredLineFit::has_slope(4, 2));
    CHECK_FALSE(CentredLineFit::has_slope(0, 2));
}

TEST_CASE("a period of zero is refused") { CHECK_THROWS_AS(CentredLineFit{0}, std::invalid_argument); }
