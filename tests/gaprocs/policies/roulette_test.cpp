#include "gaprocs/policies/reproduction.hpp"
#include "runtime/random.hpp"

#include <doctest/doctest.h>

#include <array>
#include <limits>
#include <stdexcept>

using namespace placedpar;

TEST_CASE("roulette draws individuals in proportion to fitness, and none of fitness <= 0") {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    std::array<double, 9> fitness{0, 100, -500, 200, nan, 300, 400, 0, -1};
    RandomStream random(1, "roulette");
    constexpr int draws = 100000;
    auto parents = RouletteReproduction{}(fitness, draws, random);
    REQUIRE(parents);
    std::array<int, 9> seen{};
    for (std::size_t parent : *parents)
        ++seen.at(parent);
    double chi_squared = 0;
    for (std::size_t i = 0; i < fitness.size(); ++i) {
        double expected = fitness.at(i) > 0 ? draws * fitness.at(i) / 1000 : 0;
        if (expected > 0)
            chi_squared += (seen.at(i) - expected) * (seen.at(i) - expected) / expected;
        else
            CHECK(seen.at(i) == 0);
    }
    CHECK(chi_squared < 16.27); // 3 degrees of freedom, 99.9 %
}

TEST_CASE("a ball on the border of two sectors is in the upper one, and never in an empty sector") {
    RouletteWheel wheel(std::array<double, 7>{0, -3, 1, 0, 1, 2, 0});
    CHECK(wheel.sector(0) == 2);
    CHECK(wheel.sector(0.25 - 0x1p-32) == 2);
    CHECK(wheel.sector(0.25) == 4);
    CHECK(wheel.sector(0.5) == 5);
    CHECK(wheel.sector(1 - 0x1p-32) == 5);
}

TEST_CASE("roulette returns nothing and draws nothing if no fitness is positive") {
    RandomStream random(1, "roulette"), untouched = random;
    std::array<double, 3> fitness{0, -1, -4000};
    CHECK_FALSE(RouletteReproduction{}(fitness, 3, random));
    CHECK_FALSE(RouletteReproduction{}({}, 3, random));
    CHECK(random() == untouched());
}

TEST_CASE("a sum of fitness beyond the range of a double is refused") {
    RandomStream random(1, "roulette");
    std::array<double, 2> fitness{1e308, 1e308};
    CHECK_THROWS_AS(RouletteReproduction{}(fitness, 2, random), std::invalid_argument);
}

TEST_CASE("by roulette, the only individual of positive fitness is the parent of all, whatever its index") {
    for (std::size_t place = 0; place < 3; ++place) {
        std::array<double, 3> fitness{};
        fitness.at(place) = 0x1p-20;
        RandomStream random(2, "only one");
        auto parents = RouletteReproduction{}(fitness, 500, random);
        REQUIRE(parents);
        for (std::size_t parent : *parents)
            REQUIRE(parent == place);
    }
}
