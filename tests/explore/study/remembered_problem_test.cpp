// Tests that a remembered problem evaluates each string and coding once.

#include "explore/study/remembered_problem.hpp"
#include "runtime/random.hpp"
#include "tests/gaprocs/objectives.hpp"

#include <doctest/doctest.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

using namespace placedpar;

namespace {

/// A valley that counts its evaluations.
struct CountedValley : Valley {
    std::shared_ptr<int> evaluations = std::make_shared<int>(0);
    double objective(std::span<const double> x) const {
        ++*evaluations;
        return Valley::objective(x) / 3;
    }
};

/// Returns all strings of eight bits.
std::vector<Genome> strings_of_a_valley() {
    std::vector<Genome> all(256, Genome(8));
    for (std::size_t i = 0; i < all.size(); ++i)
        all[i].set_field(0, 8, i);
    return all;
}

std::vector<double> fitness_of_all(const SearchProblem& problem) {
    std::vector<Genome> strings = strings_of_a_valley();
    std::vector<double> fitness(strings.size());
    problem.fitness_of(strings, {}, 0, fitness);
    return fitness;
}

} // namespace

TEST_CASE("each string is evaluated once in each coding, with the fitness that the problem gives it") {
    CountedValley valley;
    auto plain = minimise(valley);
    RememberedProblem remembered(plain);
    for (const Coding& coding : {Coding::natural, Coding::gray}) {
        std::vector<double> expected = fitness_of_all(*plain->coded(coding));
        *valley.evaluations = 0;
        for (int again = 0; again < 3; ++again)
            CHECK(fitness_of_all(*remembered.coded(coding)) == expected);
        CHECK(*valley.evaluations == 256);
    }
}

TEST_CASE("strings that differ only in don't-care bits are evaluated once") {
    CountedValley valley;
    RememberedProblem remembered(minimise(valley));
    fitness_of_all(*remembered.coded(Coding::gray));
    auto stuffed = remembered.coded(Coding::named("gray(dont_care = 1)"));
    RandomStream random(1, "strings");
    auto expected = minimise(valley)->coded(Coding::named("gray(dont_care = 1)"));
    for (int i = 0; i < 100; ++i) {
        Genome string = Genome::random(stuffed->bits(), random);
        double fitness = expected->fitness(string, {}, 0);
        *valley.evaluations = 0;
        CHECK(stuffed->fitness(string, {}, 0) == fitness);
        CHECK(*valley.evaluations == 0);
    }
}

TEST_CASE("several problems share one bound on remembered strings") {
    CountedValley valley, other;
    auto room = std::make_shared<std::size_t>(10'000);
    {
        RememberedProblem first(minimise(valley), room), second(minimise(other), room);
        const std::vector<double> expected = fitness_of_all(*minimise(CountedValley{}));
        for (const SearchProblem* each : {&first, &second, &first})
            CHECK(fitness_of_all(*each) == expected);
        CHECK(*valley.evaluations > 256); // some strings were forgotten and evaluated again
        CHECK(*valley.evaluations <= 512);
        CHECK(*other.evaluations == 256);
        CHECK(*room < 10'000);
    }
    CHECK(*room == 10'000);
}

TEST_CASE("registries share the problems of a family that have equal numbers") {
    RememberedProblems problems;
    ProblemFamily one = problems.around(minimised<Valley>()), other = problems.around(minimised<Valley>());
    CHECK(one.make({2, -1}) == other.make({2, -1}));
    CHECK(one.make({2, -1}) != other.make({3, -1}));
    CHECK(std::dynamic_pointer_cast<const RememberedProblem>(one.make({2, -1})));
}
