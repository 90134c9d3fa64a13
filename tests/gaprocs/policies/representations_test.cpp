// Tests the operators for strings that are not binary.

#include "gaprocs/policies/acceptance.hpp"
#include "gaprocs/policies/crossover.hpp"
#include "gaprocs/policies/mutation.hpp"
#include "runtime/random.hpp"
#include "tests/nearly.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <vector>

using namespace placedpar;

namespace {

const Representation unit_reals = RealVector(3, {0, 1}), tours = Permutation(7);

double mean_of(const std::vector<double>& numbers) {
    return std::accumulate(numbers.begin(), numbers.end(), 0.0) / static_cast<double>(numbers.size());
}

double deviation_of(const std::vector<double>& numbers) {
    double mean = mean_of(numbers), sum = 0;
    for (double each : numbers)
        sum += (each - mean) * (each - mean);
    return std::sqrt(sum / static_cast<double>(numbers.size()));
}

/// Returns `count` mutants of the number 0, whose range is -8 to 8.
std::vector<double> mutants(const char* way, double probability, int count) {
    const Representation one = RealVector(1, {-8, 8});
    std::vector<Genome> population(static_cast<std::size_t>(count), one.read("0"));
    RandomStream random(2, "mutants");
    Mutation::named(way)(population, probability, one, random);
    std::vector<double> numbers;
    for (const Genome& each : population)
        numbers.push_back(one.reals().value(each, 0));
    return numbers;
}

bool is_permutation(const Genome& genome) {
    auto order = tours.permutation().decode(genome);
    std::ranges::sort(order);
    for (std::size_t i = 0; i < order.size(); ++i)
        if (order[i] != i)
            return false;
    return order.size() == 7;
}

} // namespace

TEST_CASE("each operator states which strings it fits") {
    CHECK(Crossover::fitting(StringKind::binary) ==
          std::vector<std::string>{"one-point", "two-point", "uniform", "by-difference"});
    CHECK(Crossover::fitting(StringKind::real) ==
          std::vector<std::string>{"one-point", "two-point", "uniform", "blend", "sbx"});
    CHECK(Crossover::fitting(StringKind::permutation) == std::vector<std::string>{"order"});
    CHECK(Mutation::fitting(StringKind::binary) == std::vector<std::string>{"bit", "distance"});
    CHECK(Mutation::fitting(StringKind::real) ==
          std::vector<std::string>{"gaussian", "breeder", "polynomial", "uniform"});
    CHECK(Mutation::fitting(StringKind::permutation) == std::vector<std::string>{"swap", "inversion"});
    CHECK_FALSE(Mutation().fits(StringKind::real));
    CHECK(Mutation::named("gaussian(0.2)").text() == "gaussian(deviation = 0.2)");
}

TEST_CASE("gaussian mutation has the stated deviation and rate, and stays in the range") {
    auto all = mutants("gaussian(0.1)", 1, 20000);
    CHECK(std::abs(mean_of(all)) < 0.06);
    CHECK(deviation_of(all) == doctest::Approx(1.6).epsilon(0.03));
    auto some = mutants("gaussian", 0.25, 20000);
    CHECK(std::abs(std::ranges::count(some, 0.0) - 15000) < 310); // five standard deviations
    auto wide = mutants("gaussian(10)", 1, 1000);
    CHECK(*std::ranges::min_element(wide) == -8);
    CHECK(*std::ranges::max_element(wide) == 8);
}

TEST_CASE("breeder mutation makes steps of every size in both directions") {
    auto steps = mutants("breeder(range = 0.5, precision = 10)", 1, 20000);
    int up = 0, small = 0;
    for (double step : steps) {
        up += step > 0;
        small += std::abs(step) < 0.25; // half of all steps, because sizes are uniform on a logarithmic scale
        CHECK(std::abs(step) <= 8);
        CHECK(std::abs(step) >= 8 * 0x1p-10);
    }
    CHECK(std::abs(up - 10000) < 360);
    CHECK(std::abs(small - 10000) < 360);
}

TEST_CASE("polynomial mutation stays in the range, is symmetric in its middle, and has the published mean step") {
    auto all = mutants("polynomial(index = 20)", 1, 20000);
    double steps = 0;
    for (double step : all) {
        CHECK(std::abs(step) <= 8);
        steps += std::abs(step) / 16 / 20000;
    }
    CHECK(std::abs(mean_of(all)) < 0.06);
    // The step's share of the range is 1 - u^(1/21), u uniform in 0 ... 1, if the bounds are far away: 1/22 on average.
    CHECK(steps == doctest::Approx(1 / 22.0).epsilon(0.03));
}

TEST_CASE("simulated binary crossover keeps the parents' mean far from bounds, the stated spread, and the range") {
    RandomStream random(4, "sbx");
    double spread = 0;
    int crossed = 0;
    for (int i = 0; i < 20000; ++i) {
        std::vector<Genome> pair{unit_reals.read("0.499 0.5 0.001"), unit_reals.read("0.501 0.5 0.9")};
        Crossover(SimulatedBinaryCrossover{15})(pair, 1, unit_reals, random);
        auto value = [&](std::size_t child, std::size_t number) {
            return unit_reals.reals().value(pair[child], number);
        };
        CHECK((value(0, 0) + value(1, 0)) / 2 == doctest::Approx(0.5));
        CHECK((value(0, 1) == 0.5 && value(1, 1) == 0.5));
        CHECK(std::min(value(0, 2), value(1, 2)) >= 0);
        const double ratio = std::abs(value(0, 0) - value(1, 0)) / 0.002;
        crossed += std::abs(ratio - 1) > 1e-9;
        spread += std::abs(ratio - 1) > 1e-9 && ratio < 1;
    }
    CHECK(std::abs(crossed - 10000) < 360);        // each number is crossed with probability 1/2
    CHECK(std::abs(spread - crossed / 2.0) < 260); // half of the offspring are nearer to each other than their parents
}

TEST_CASE("uniform mutation draws a new number, uniform in the range") {
    auto all = mutants("uniform", 1, 20000);
    CHECK(std::abs(mean_of(all)) < 0.17);
    CHECK(deviation_of(all) == doctest::Approx(16 / std::sqrt(12)).epsilon(0.03));
}

TEST_CASE("one-point, two-point and uniform crossover keep each number whole and at its position") {
    RandomStream random(3, "numbers");
    for (const char* way : {"one-point", "two-point", "uniform"}) {
        std::map<std::string, int> seen;
        for (int i = 0; i < 4000; ++i) {
            std::vector<Genome> pair{unit_reals.read("0.1 0.2 0.3"), unit_reals.read("0.6 0.7 0.8")};
            Crossover::named(way)(pair, 1, unit_reals, random);
            ++seen[unit_reals.text(pair[0])];
        }
        CAPTURE(way);
        CHECK(seen.size() == (std::string(way) == "uniform" ? 8 : std::string(way) == "one-point" ? 2 : 3));
        CHECK(seen.contains("0.6 0.2 0.3"));
        CHECK(std::ranges::all_of(seen, [&](const auto& each) { return each.second > 4000 / 16; }));
    }
}

TEST_CASE("blend crossover is uniform in the extended interval between the parents, and stays in the range") {
    RandomStream random(4, "blend");
    std::vector<double> first, last;
    for (int i = 0; i < 10000; ++i) {
        std::vector<Genome> pair{unit_reals.read("0.4 0.5 0.1"), unit_reals.read("0.6 0.5 0.9")};
        Crossover(BlendCrossover{0.5})(pair, 1, unit_reals, random);
        for (const Genome& each : pair) {
            first.push_back(unit_reals.reals().value(each, 0));
            CHECK(unit_reals.reals().value(each, 1) == 0.5);
            last.push_back(unit_reals.reals().value(each, 2));
        }
    }
    CHECK(mean_of(first) == test::nearly(0.5, 0.01));
    CHECK(deviation_of(first) == test::nearly(0.4 / std::sqrt(12), 0.02));
    CHECK(*std::ranges::min_element(last) == 0);
    CHECK(*std::ranges::max_element(last) == 1);
}

namespace {

/// Returns all offspring that keep a part of one parent and have the rest in the order of the other parent.
std::set<std::string> all_offspring(const std::vector<std::size_t>& kept, const std::vector<std::size_t>& other) {
    std::set<std::string> all;
    for (std::size_t first = 0; first < 7; ++first)
        for (std::size_t length = 1; length < 7; ++length) {
            std::vector<std::size_t> offspring;
            for (std::size_t i = 0; i < length; ++i)
                offspring.push_back(kept[(first + i) % 7]);
            for (std::size_t i = 0; i < 7; ++i)
                if (std::size_t each = other[(first + length + i) % 7]; std::ranges::count(offspring, each) == 0)
                    offspring.push_back(each);
            std::rotate(offspring.begin(), offspring.end() - static_cast<std::ptrdiff_t>(first), offspring.end());
            all.insert(tours.text(tours.permutation().encode(offspring)));
        }
    return all;
}

} // namespace

TEST_CASE("order crossover makes all permutations that keep a part of one parent and the order of the other") {
    RandomStream random(5, "order");
    Genome a = tours.random(random), b = tours.random(random);
    auto order_a = tours.permutation().decode(a), order_b = tours.permutation().decode(b);
    std::set<std::string> firsts, seconds;
    for (int i = 0; i < 2000; ++i) {
        std::vector<Genome> pair{a, b};
        Crossover(OrderCrossover{})(pair, 1, tours, random);
        REQUIRE(is_permutation(pair[0]));
        firsts.insert(tours.text(pair[0]));
        seconds.insert(tours.text(pair[1]));
    }
    CHECK(firsts == all_offspring(order_a, order_b));
    CHECK(seconds == all_offspring(order_b, order_a));
    std::vector<Genome> equals{a, a};
    Crossover(OrderCrossover{})(equals, 1, tours, random);
    CHECK(equals[0] == a);
}

TEST_CASE("swap changes at most four edges of a tour, and inversion at most two") {
    RandomStream random(6, "mutate");
    for (int i = 0; i < 500; ++i) {
        Genome tour = tours.random(random), swapped = tour, turned = tour;
        std::size_t place = random.below(7);
        SwapMutation{}(swapped, place, tours, random);
        InversionMutation{}(turned, place, tours, random);
        REQUIRE(is_permutation(swapped));
        REQUIRE(is_permutation(turned));
        CHECK(swapped != tour);
        CHECK(tours.distance(tour, swapped) <= 4);
        CHECK(tours.distance(tour, turned) <= 2);
    }
    std::vector<Genome> many = tours.random_population(50, random), same = many;
    Mutation(SwapMutation{})(many, 0, tours, random);
    CHECK(many == same);
}

TEST_CASE("strings of one number or one place can be crossed and mutated") {
    RandomStream random(7, "one");
    const Representation one_real = RealVector(1, {0, 1}), one_place = Permutation(1);
    std::vector<Genome> reals = one_real.random_population(4, random), places = one_place.random_population(4, random);
    for (const char* way : {"one-point", "two-point", "uniform", "blend"})
        CHECK_NOTHROW(Crossover::named(way)(reals, 1, one_real, random));
    Crossover(OrderCrossover{})(places, 1, one_place, random);
    for (const char* way : {"swap", "inversion"})
        Mutation::named(way)(places, 1, one_place, random);
    CHECK(one_place.text(places[0]) == "0");
}

TEST_CASE("acceptance of the most similar individual uses the representation's distance") {
    RandomStream random(8, "alike");
    std::vector<Genome> strings{tours.read("0 2 4 6 1 3 5"), tours.read("3 2 1 0 6 5 4"), tours.read("0 1 2 3 6 5 4")};
    std::vector<double> fitness{1, 2, 3};
    std::vector<Individual> immigrant{{tours.read("0 1 2 3 4 5 6"), 5}};
    // The second string is the immigrant's tour in reverse. As bits, the third is the nearest.
    CHECK(AlikeAcceptance{}({strings, fitness, 0, &tours}, immigrant, random) == Places{1});
    CHECK(AlikeAcceptance{}({strings, fitness, 0}, immigrant, random) == Places{2});
}
