#include "gaprocs/policies/crossover.hpp"
#include "runtime/random.hpp"
#include "tests/gaprocs/strings.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <set>
#include <string>

using namespace placedpar;
using test::ones_by_position;
using test::strings;

namespace {

/// Returns how often the crossover turns string `a` into each offspring.
std::map<std::string, int> offspring(const Crossover& cross, const char* a, const char* b, int pairs) {
    RandomStream random(8, "offspring");
    std::map<std::string, int> seen;
    for (int i = 0; i < pairs; ++i) {
        auto population = strings({a, b});
        cross(population, 1, BitString(population.front().size()), random);
        ++seen[population.front().to_string()];
    }
    return seen;
}

/// Checks that there are `kinds` offspring, equally frequent within five standard deviations.
void check_even(const std::map<std::string, int>& seen, std::size_t kinds) {
    CHECK(seen.size() == kinds);
    double all = 0;
    for (const auto& [text, count] : seen)
        all += count;
    double share = 1 / static_cast<double>(kinds), deviation = std::sqrt(all * share * (1 - share));
    for (const auto& each : seen) {
        CAPTURE(each.first);
        CHECK(std::abs(each.second - all * share) < 5 * deviation);
    }
}

} // namespace

TEST_CASE("every crossover keeps the bits at each position in the population") {
    RandomStream random(3, "crossover");
    for (std::size_t count : {2u, 3u, 7u, 30u})
        for (std::size_t bits : {1u, 2u, 10u, 64u, 65u, 130u}) {
            for (const char* way : {"one-point", "two-point", "uniform", "by-difference"}) {
                CAPTURE(way);
                auto population = random_population(count, bits, random);
                auto before = ones_by_position(population);
                Crossover::named(way)(population, 1, BitString(population.front().size()), random);
                CHECK(ones_by_position(population) == before);
            }
        }
}

TEST_CASE("cuts are uniform over 1 ... L - 1 and happen at the stated rate") {
    RandomStream random(4, "cuts");
    constexpr int pairs = 50000;
    std::map<std::string, int> seen;
    for (int i = 0; i < pairs; ++i) {
        auto population = strings({"00000", "11111"});
        Crossover()(population, 0.8, BitString(5), random);
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
    Crossover()(population, 1, BitString(population.front().size()), random);
    CHECK(population == strings({"0", "1", "1"}));
}

TEST_CASE(
    "the last of an odd number of individuals has no mate; by difference, an individual that is too similar has none") {
    RandomStream random(9, "odd");
    for (const char* way : {"one-point", "two-point", "uniform"}) {
        auto population = random_population(7, 30, random);
        Genome last = population.back();
        Crossover::named(way)(population, 1, BitString(population.front().size()), random);
        CHECK(population.back() == last);
    }
    auto population = strings({"0000", "0001", "1111"}); // the second is too similar to the first, so the third is the
                                                         // first's mate
    Crossover(DifferenceCrossover{})(population, 1, BitString(population.front().size()), random);
    CHECK(population[2] == Genome::from_string("0001"));
    CHECK(population[0] != Genome::from_string("0000"));
}

TEST_CASE("two-point crossover exchanges each piece of the ring with the same probability") {
    // Four positions have 6 pairs of cuts; the second offspring is the complement.
    auto seen = offspring(TwoPointCrossover{}, "0000", "1111", 60000);
    check_even(seen, 6);
    for (const char* never : {"0000", "1111", "0101", "1010"})
        CHECK(!seen.contains(never));
}

TEST_CASE("uniform crossover makes each possible offspring with the same probability") {
    check_even(offspring(UniformCrossover{}, "00010", "11110", 60000), 8); // the parents differ in three places
}

TEST_CASE("crossover by difference always makes new strings, and all possible cuts have the same probability") {
    // The parents differ at the positions 1, 4 and 5. A cut at 2, 3 or 4 exchanges the first different bit; a cut at 5
    // exchanges the first two.
    auto seen = offspring(DifferenceCrossover{}, "000000", "010011", 40000);
    CHECK(seen.size() == 2);
    CHECK(std::abs(seen["010000"] - 30000) < 5 * std::sqrt(40000 * .75 * .25));
    CHECK(seen["010010"] == 40000 - seen["010000"]);
}

TEST_CASE("crossover by difference leaves parents that differ in one bit unchanged") {
    CHECK(offspring(DifferenceCrossover{}, "000000", "010000", 100).at("000000") == 100);
}

TEST_CASE(
    "one-point crossover of parents that differ in all n bits reaches 2 (n - 1) new strings (thesis, table 6.2)") {
    for (std::size_t n : {2u, 3u, 8u}) {
        std::string zeros(n, '0'), ones(n, '1');
        auto firsts = offspring(OnePointCrossover{}, zeros.c_str(), ones.c_str(), 2000);
        CHECK(firsts.size() == n - 1); // the second offspring is the complement
    }
}

TEST_CASE("many draws of a crossover make exactly the strings of every_offspring") {
    for (const char* way : {"one-point", "two-point", "uniform", "by-difference"})
        for (unsigned pair = 0; pair < 256; ++pair) {
            Genome a(4), b(4);
            a.set_field(0, 4, pair / 16);
            b.set_field(0, 4, pair % 16);
            CAPTURE(way);
            CAPTURE(pair);
            Crossover cross = Crossover::named(way);
            std::set<std::uint64_t> seen;
            RandomStream random(pair, way);
            bool mates = std::string(way) != "by-difference" || difference(a, b) >= 2;
            for (int i = 0; i < (mates ? 200 : 0); ++i) {
                auto population = std::vector{a, b};
                cross(population, 1, BitString(4), random);
                for (const Genome& each : population)
                    seen.insert(each.field(0, 4));
            }
            CHECK(cross.every_offspring(a, b) == seen);
        }
}
