// Tests diversity, which is computed without a loop over pairs, against the distances of all pairs.

#include "gaprocs/diversity.hpp"
#include "runtime/random.hpp"
#include "tests/gaprocs/strings.hpp"
#include "tests/nearly.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>

using namespace placedpar;

namespace {

/// Computes mean distances pair by pair. If `of_squares`, computes the root of the mean square distance.
struct Pairs {
    const Representation& representation;
    double greatest; ///< greatest distance
    bool of_squares = false;

    double share(const Genome& a, const Genome& b) const {
        double distance = representation.distance(a, b) / greatest;
        return of_squares ? distance * distance : distance;
    }
    double across(const std::vector<Genome>& first, const std::vector<Genome>& second) const {
        double sum = 0;
        for (const Genome& a : first)
            for (const Genome& b : second)
                sum += share(a, b);
        return sum / static_cast<double>(first.size() * second.size());
    }
    double mean(double value) const { return of_squares ? std::sqrt(value) : value; }
    double within(const std::vector<Genome>& population) const {
        auto size = static_cast<double>(population.size());
        return mean(across(population, population) * size / (size - 1));
    }
};

double within(const std::vector<Genome>& population) {
    return diversity_within(spread_of(population, BitString(population.empty() ? 1 : population.front().size())));
}

Spread four_bits(std::initializer_list<const char*> texts) { return spread_of(test::strings(texts), BitString(4)); }

/// Compares diversity with the distances of all pairs, for several sizes of population. In one population almost all
/// individuals are equal.
void check_pairs(const Representation& representation, double greatest, bool of_squares = false) {
    RandomStream random(1, "diversity");
    Pairs pairs{representation, greatest, of_squares};
    for (std::size_t individuals : {2u, 3u, 10u, 33u}) {
        auto first = representation.random_population(individuals, random);
        auto second = representation.random_population(individuals + 5, random);
        std::vector<Genome> third(4, second.front());
        third.push_back(first.front());
        CHECK(diversity_within(spread_of(first, representation)) == doctest::Approx(pairs.within(first)));
        CHECK(diversity_within(spread_of(third, representation)) == doctest::Approx(pairs.within(third)));
        Spread populations[] = {spread_of(first, representation), spread_of(second, representation),
                                spread_of(third, representation)};
        double across = pairs.across(first, second) + pairs.across(first, third) + pairs.across(second, third);
        CHECK(diversity_between(populations) == doctest::Approx(pairs.mean(across / 3)));
    }
}

} // namespace

TEST_CASE("diversity within a population has the values computed by hand") {
    CHECK(within(test::strings({"0000", "0000", "0000"})) == 0);
    CHECK(within(test::strings({"0000", "1111"})) == 1);
    CHECK(within(test::strings({"0001", "0011", "0111"})) == (1.0 + 2 + 1) / 3 / 4);
    CHECK(within(test::strings({"0101"})) == 0);
    CHECK(within({}) == 0);
}

TEST_CASE("diversity between populations has the values computed by hand") {
    Spread populations[] = {four_bits({"0000", "0000"}), four_bits({"1100", "1110"}), four_bits({"1111"})};
    CHECK(diversity_between(std::span(populations).first(2)) == 2.5 / 4);
    CHECK(diversity_between(populations) == doctest::Approx((2.5 + 4 + 1.5) / 3 / 4));
    CHECK(fixation(0.25, 0.5) == 0.5);
    CHECK(fixation(0, 0) == 0);
    CHECK(fixation(0, 0.3) == 1);
}

TEST_CASE("the diversity of binary strings equals the mean distance of all pairs") {
    for (std::size_t bits : {1u, 7u, 63u, 64u, 65u, 200u})
        check_pairs(BitString(bits), static_cast<double>(bits));
}

TEST_CASE("the diversity of tours equals the mean distance of all pairs, and is 0 for tours of three places") {
    for (std::size_t places : {4u, 5u, 30u})
        check_pairs(Permutation(places), static_cast<double>(places));
    RandomStream random(3, "few places");
    for (std::size_t places : {1u, 2u, 3u}) {
        auto population = Representation(Permutation(places)).random_population(7, random);
        CHECK(diversity_within(spread_of(population, Permutation(places))) == 0);
    }
}

TEST_CASE(
    "the diversity of real vectors is the root of the mean square distance of all pairs, in widths of the ranges") {
    check_pairs(RealVector({{-1, 1}, {0, 1e6}, {3, 3.5}}), std::sqrt(3), true);
    check_pairs(RealVector(1, {0, 8}), 1, true);
    RealVector line(1, {0, 8});
    std::vector<Genome> ends(2, Genome(64));
    line.set(ends[0], 0, 8);
    line.set(ends[1], 0, 0);
    CHECK(diversity_within(spread_of(ends, line)) == 1);
    line.set(ends[1], 0, 8 - 8e-12);
    CHECK(diversity_within(spread_of(ends, line)) == test::nearly(1e-12, 1e-3));
}

TEST_CASE("random individuals have the expected diversity") {
    RandomStream random(2, "half");
    auto check = [&](const Representation& representation, double expected) {
        Spread populations[] = {spread_of(representation.random_population(200, random), representation),
                                spread_of(representation.random_population(200, random), representation)};
        CHECK(diversity_within(populations[0]) == test::nearly(expected, 0.01));
        CHECK(diversity_between(populations) == test::nearly(expected, 0.01));
    };
    check(BitString(500), 0.5);
    check(RealVector(100, {-5, 5}), std::sqrt(1.0 / 6));
    check(Permutation(41), 1 - 2.0 / 40);
}
