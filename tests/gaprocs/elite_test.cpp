#include "gaprocs/traditional.hpp"
#include "gaprocs/window.hpp"
#include "tests/gaprocs/line_problem.hpp"
#include "tests/gaprocs/strings.hpp"
#include "tests/nearly.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <stdexcept>

using namespace placedpar;
using test::strings;

namespace {

SearchSettings with_elite(std::size_t elite, std::size_t population) {
    SearchSettings settings;
    settings.elite = elite;
    settings.population = population;
    return settings;
}

/// Returns how often the best fitness falls from one generation to the next while the window stays the same.
int falls(const SearchSettings& settings, std::uint64_t seed) {
    auto problem = make_search_problem(LineProblem{});
    auto window = line_record(10);
    Search search(problem->bits(), settings, RandomStream(seed, "fixed window"));
    int count = 0;
    for (double best = -1e300; search.generation() < 100; best = search.best().fitness) {
        search.next_generation(evaluate(*problem, search.population(), window, 400));
        count += search.best().fitness < best;
    }
    return count;
}

} // namespace

TEST_CASE("best_indices returns the best first, and among equals the lowest index first") {
    using Indices = std::vector<std::size_t>;
    const std::array<double, 6> fitness{3, 7, -1, 7, 9, 3};
    CHECK(best_indices(fitness, 0).empty());
    CHECK(best_indices(fitness, 1) == Indices{4});
    CHECK(best_indices(fitness, 3) == Indices{4, 1, 3});
    CHECK(best_indices(fitness, 6) == Indices{4, 1, 3, 0, 5, 2});
}

TEST_CASE("the elite is first in the next population, unchanged and in descending order") {
    SearchSettings settings = with_elite(2, 6);
    settings.mutation_probability = 1; // no individual outside the elite stays unchanged
    settings.crossover_probability = 0;
    auto population = strings({"0000", "0001", "0010", "0011", "0100", "0101"});
    Search search(population, settings, RandomStream(1, "elite"));
    search.next_generation(std::array<double, 6>{0, 0, 5, 0, 9, 0});
    REQUIRE(search.population().size() == 6);
    CHECK(search.population()[0] == population[4]);
    CHECK(search.population()[1] == population[2]);
    for (std::size_t i = 2; i < 6; ++i) {
        // The parents are the two individuals of positive fitness, and mutation has flipped all their bits.
        std::string text = search.population()[i].to_string();
        CHECK((text == "1011" || text == "1101"));
    }
}

TEST_CASE("the elite stays when no individual has positive fitness and the others are drawn anew") {
    std::vector<Genome> population(5, Genome(64));
    population[3].flip(7);
    Search search(population, with_elite(1, 5), RandomStream(1, "anew"));
    search.next_generation(std::array<double, 5>{-5, -6, -7, -1, -3});
    CHECK(search.redraws() == 1);
    CHECK(search.population()[0] == population[3]);
    for (std::size_t i = 1; i < 5; ++i)
        CHECK(search.population()[i] != Genome(64));
}

TEST_CASE("while the window stays the same, the best fitness never falls with an elite, but does without one") {
    int lost = 0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        lost += falls(with_elite(0, 8), seed);
        for (std::size_t elite : {1u, 2u, 6u})
            CHECK(falls(with_elite(elite, 8), seed) == 0);
        SearchSettings universal = with_elite(1, 9);
        universal.reproduction = UniversalReproduction{};
        CHECK(falls(universal, seed) == 0);
    }
    CHECK(lost > 20);
}

TEST_CASE("when the window moves, the elite is evaluated again") {
    // The slope of the line changes after ten samples, so the former best must not keep the old fitness.
    auto record = line_record(30);
    for (std::size_t k = 10; k < 30; ++k)
        record[k][1] = 40.0 / 256 * record[k][0];
    auto problem = make_search_problem(LineProblem{});
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        SearchSettings settings = with_elite(2, 60);
        SearchResult result = run_traditional(*problem, record, settings, RandomStream(seed, "moves"));
        for (const Estimate& estimate : result.estimates) {
            std::size_t end = estimate.sample + 1, first = end - std::min<std::size_t>(end, 10);
            CHECK(estimate.best.fitness ==
                  problem->fitness(estimate.best.genome, std::span(record).subspan(first, end - first), 400));
        }
        CHECK(result.estimates.back().parameters.at(0) == test::nearly(40.0 / 256, 0.02));
    }
}

TEST_CASE("an elite that leaves no pair is refused") {
    CHECK_THROWS_WITH_AS(Search(4, with_elite(3, 4), RandomStream(1, "no pair")),
                         "the elite is 3 of a population of 4, expected at most 2: crossover needs two parents",
                         UserError);
    CHECK_NOTHROW(Search(4, with_elite(2, 4), RandomStream(1, "one pair")));
}
