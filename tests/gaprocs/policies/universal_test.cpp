// Tests stochastic universal sampling.

#include "gaprocs/policies/reproduction.hpp"
#include "runtime/random.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

using namespace placedpar;

namespace {

using Indices = std::vector<std::size_t>;

std::vector<int> counts(const Indices& parents, std::size_t individuals) {
    std::vector<int> seen(individuals);
    for (std::size_t parent : parents)
        ++seen.at(parent);
    return seen;
}

} // namespace

TEST_CASE("evenly spaced balls fall into sectors of widths 1, 2 and 1 in proportion") {
    RouletteWheel wheel(std::array<double, 5>{1, -7, 2, 0, 1});
    CHECK(wheel.sectors(4, 0) == Indices{0, 2, 2, 4});
    CHECK(wheel.sectors(4, 0.999) == Indices{0, 2, 2, 4});
    CHECK(wheel.sectors(2, 0.25) == Indices{0, 2}); // balls at 0.5 and 2.5 of 4
    CHECK(wheel.sectors(2, 0.75) == Indices{2, 4}); // balls at 1.5 and 3.5 of 4
    CHECK(wheel.sectors(1, 1 - 0x1p-32) == Indices{4});
    CHECK(wheel.sectors(8, 0.5) == Indices{0, 0, 2, 2, 2, 2, 4, 4});
}

TEST_CASE("in universal sampling each individual becomes a parent floor(e) or ceil(e) times, whatever the spin") {
    RandomStream random(1, "universal");
    for (int run = 0; run < 2000; ++run) {
        std::size_t individuals = 1 + random.below(40), count = 1 + random.below(130);
        std::vector<double> fitness(individuals);
        for (double& each : fitness)
            each = (random.uniform() - 0.3) * 400;
        fitness.front() = 100; // at least one fitness is positive
        double sum = 0;
        for (double each : fitness)
            sum += std::max(each, 0.0);
        auto parents = UniversalReproduction{}(fitness, count, random);
        REQUIRE(parents);
        REQUIRE(parents->size() == count);
        auto seen = counts(*parents, individuals);
        for (std::size_t i = 0; i < individuals; ++i) {
            double expected = static_cast<double>(count) * std::max(fitness[i], 0.0) / sum;
            REQUIRE(seen[i] >= std::floor(expected - 1e-9));
            REQUIRE(seen[i] <= std::ceil(expected + 1e-9));
        }
    }
}

TEST_CASE("in universal sampling the mean number of copies is that of roulette") {
    RandomStream random(2, "universal");
    const std::array<double, 3> fitness{1, 2, 5}; // expected numbers of copies: 0.375, 0.75, 1.875
    std::array<int, 3> seen{};
    constexpr int spins = 20000;
    for (int spin = 0; spin < spins; ++spin) {
        auto parents = UniversalReproduction{}(fitness, 3, random).value();
        for (std::size_t parent : parents)
            ++seen.at(parent);
    }
    // In one spin, the number of copies is one of two neighbouring integers, so its standard deviation is at most 0.5.
    // The check allows four standard deviations of the sum.
    for (std::size_t i = 0; i < 3; ++i)
        CHECK(std::abs(seen.at(i) - spins * 3 * fitness.at(i) / 8) < 4 * 0.5 * std::sqrt(spins));
}

TEST_CASE("universal sampling shuffles the parents: each is equally often at each place") {
    RandomStream random(3, "universal");
    const std::array<double, 4> fitness{1, 1, 1, 1};
    constexpr int runs = 20000;
    std::array<std::array<int, 4>, 4> at{};
    for (int run = 0; run < runs; ++run) {
        auto parents = UniversalReproduction{}(fitness, 4, random).value();
        for (std::size_t place = 0; place < 4; ++place)
            ++at.at(place).at(parents[place]);
        std::sort(parents.begin(), parents.end());
        REQUIRE(parents == Indices{0, 1, 2, 3});
    }
    for (const auto& place : at)
        for (int seen : place)
            CHECK(std::abs(seen - runs / 4) < 250); // 4.1 standard deviations
}

TEST_CASE("universal sampling returns nothing and draws nothing if no fitness is positive") {
    RandomStream random(1, "nothing"), untouched = random;
    std::array<double, 3> fitness{0, -1, std::numeric_limits<double>::quiet_NaN()};
    CHECK_FALSE(UniversalReproduction{}(fitness, 3, random));
    CHECK(random() == untouched());
}

TEST_CASE("in universal sampling the only individual of positive fitness is the parent of all, whatever its index") {
    for (std::size_t place = 0; place < 3; ++place) {
        std::array<double, 3> fitness{-1, -1, -1};
        fitness.at(place) = 1 / 3.0;
        RouletteWheel wheel(fitness);
        for (double turn : {0.0, 0.5, 1 - 0x1p-32})
            for (std::size_t count : {1u, 7u, 1000u})
                CHECK(wheel.sectors(count, turn) == Indices(count, place));
    }
}

TEST_CASE("a last ball that rounding puts on the end of the wheel is in the last sector that is not empty") {
    constexpr std::size_t balls = std::size_t{1} << 23; // from this size on, balls - 2^-32 rounds to balls
    RouletteWheel wheel(std::array<double, 4>{1, 0, 1, 0});
    auto found = wheel.sectors(balls, 1 - 0x1p-32);
    CHECK(found.back() == 2);
    CHECK(found[balls / 4] == 0);
    CHECK(found[balls / 2 + 1] == 2);
}
