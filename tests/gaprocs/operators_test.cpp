#include "gaprocs/operators.hpp"
#include "tests/gaprocs/strings.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>

using namespace placedpar;
using test::strings;

namespace {

std::vector<int> ones_by_position(const std::vector<Genome>& population) {
    std::vector<int> ones(population.front().size());
    for (const Genome& genome : population)
        for (std::size_t bit = 0; bit < genome.size(); ++bit)
            ones[bit] += genome.bit(bit);
    return ones;
}

} // namespace

TEST_CASE("roulette draws in proportion to fitness, and nobody of fitness <= 0") {
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

TEST_CASE("a ball on the border of two sectors lies in the upper one, and never where there is no sector") {
    RouletteWheel wheel(std::array<double, 7>{0, -3, 1, 0, 1, 2, 0});
    CHECK(wheel.sector(0) == 2);
    CHECK(wheel.sector(0.25 - 0x1p-32) == 2);
    CHECK(wheel.sector(0.25) == 4);
    CHECK(wheel.sector(0.5) == 5);
    CHECK(wheel.sector(1 - 0x1p-32) == 5);
}

TEST_CASE("roulette has no answer when no fitness is positive, and draws nothing") {
    RandomStream random(1, "roulette"), untouched = random;
    std::array<double, 3> fitness{0, -1, -4000};
    CHECK_FALSE(RouletteReproduction{}(fitness, 3, random));
    CHECK_FALSE(RouletteReproduction{}({}, 3, random));
    CHECK(random() == untouched());
}

TEST_CASE("a fitness sum beyond a double is refused") {
    RandomStream random(1, "roulette");
    std::array<double, 2> fitness{1e308, 1e308};
    CHECK_THROWS_AS(RouletteReproduction{}(fitness, 2, random), std::invalid_argument);
}

TEST_CASE("the only positive one is everybody's parent, wherever it stands") {
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

TEST_CASE("crossover keeps the bits at every position, whatever the population") {
    RandomStream random(3, "crossover");
    for (std::size_t count : {2u, 3u, 7u, 30u})
        for (std::size_t bits : {1u, 2u, 10u, 64u, 65u, 130u}) {
            auto population = random_population(count, bits, random);
            auto before = ones_by_position(population);
            auto last = population.back();
            OnePointCrossover{1}(population, random);
            CHECK(ones_by_position(population) == before);
            if (count % 2 == 1)
                CHECK(population.back() == last);
        }
}

TEST_CASE("cuts are uniform over 1 ... L - 1 and happen at the stated rate") {
    RandomStream random(4, "cuts");
    constexpr int pairs = 50000;
    std::map<std::string, int> seen;
    for (int i = 0; i < pairs; ++i) {
        auto population = strings({"00000", "11111"});
        OnePointCrossover{0.8}(population, random);
        ++seen[population.front().to_string()];
    }
    std::map<std::string, double> expected{
        {"00000", 0.2}, {"10000", 0.2}, {"11000", 0.2}, {"11100", 0.2}, {"11110", 0.2}};
    double chi_squared = 0;
    for (auto& [text, share] : expected)
        chi_squared += std::pow(seen[text] - share * pairs, 2) / (share * pairs);
    CHECK(seen.size() == expected.size());
    CHECK(chi_squared < 18.47); // 4 degrees of freedom, 99.9 %
}

TEST_CASE("strings of one character are never cut") {
    RandomStream random(5, "short");
    auto population = strings({"0", "1", "1"});
    OnePointCrossover{1}(population, random);
    CHECK(population == strings({"0", "1", "1"}));
}

TEST_CASE("mutation flips bits at the stated rate, at every position alike") {
    RandomStream random(6, "mutation");
    std::vector<Genome> population(20000, Genome(50));
    BitMutation{}(population, random);
    auto ones = ones_by_position(population);
    int total = 0;
    for (int flips : ones) {
        CHECK(std::abs(flips - 200) < 66); // 4.7 standard deviations
        total += flips;
    }
    CHECK(std::abs(total - 10000) < 390); // 3.9 standard deviations
}

TEST_CASE("mutation never and always") {
    RandomStream random(7, "mutation");
    auto population = strings({"0110", "1111"});
    BitMutation{0}(population, random);
    CHECK(population == strings({"0110", "1111"}));
    BitMutation{1}(population, random);
    CHECK(population == strings({"1001", "0000"}));
}
