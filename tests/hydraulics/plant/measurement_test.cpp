#include "hydraulics/plant/measurement.hpp"
#include "runtime/random.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>

using namespace placedpar;
using namespace placedpar::hydraulics;

TEST_CASE("Box-Muller numbers have known values, moments and tails") {
    std::array<double, 4> given{1 - std::exp(-0.5), 0, 1 - std::exp(-2), 0.5};
    std::size_t next = 0;
    UniformSource scripted = [&] { return given.at(next++); };
    CHECK(standard_normal(scripted) == doctest::Approx(1));
    CHECK(standard_normal(scripted) == doctest::Approx(-2));

    RandomStream random(5, "normal");
    UniformSource uniform = [&] { return random.uniform(); };
    constexpr int count = 100000;
    double sum = 0, squares = 0;
    int beyond_two = 0;
    for (int i = 0; i < count; ++i) {
        double value = standard_normal(uniform);
        sum += value;
        squares += value * value;
        beyond_two += std::abs(value) > 2;
    }
    CHECK(std::abs(sum / count) < 0.012);         // 3.8 standard errors
    CHECK(std::abs(squares / count - 1) < 0.017); // 3.8 standard errors
    CHECK(std::abs(beyond_two / double(count) - 0.0455) < 0.0025);
}
