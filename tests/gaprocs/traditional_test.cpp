#include "gaprocs/traditional.hpp"
#include "gaprocs/window.hpp"
#include "tests/gaprocs/line_problem.hpp"
#include "tests/sanitized.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

using namespace placedpar;

namespace {

const auto line = make_search_problem(LineProblem{});

/// Returns the fitness of each individual. Divides the samples of the window at random into parts, and adds the parts
/// in any order, as slaves do.
std::vector<double> evaluate_in_parts(std::span<const Genome> population, std::span<const Sample> window, double bias,
                                      RandomStream& deal) {
    std::vector<double> fitness(population.size(), 0);
    for (std::size_t i = 0; i < population.size(); ++i) {
        double part[3] = {};
        for (std::size_t w = window.size(); w-- > 0;)
            part[deal.below(3)] += fitness_term(bias, line->error(population[i], window[w]));
        fitness[i] = part[2] + (part[0] + part[1]);
    }
    return fitness;
}

} // namespace

TEST_CASE("a line is found with 99.9 % of the greatest possible fitness, from every seed") {
    auto record = line_record(20);
    for (std::uint64_t seed = 1; seed <= (test::sanitized ? 3 : 30); ++seed) {
        SearchResult result = run_traditional(*line, record, {}, RandomStream(seed, "line"));
        REQUIRE(result.estimates.size() == 16);
        CHECK(result.generations == 80); // 16 samples, from the fifth on, with 5 trials each
        CHECK(result.estimates.front().sample == 4);
        CHECK(result.estimates.back().sample == 19);
        const Estimate& last = result.estimates.back();
        CHECK(last.parameters == line->decode(last.best.genome));
        CHECK(last.best.fitness == line->fitness(last.best.genome, std::span(record).last(10), 400));
        CHECK(last.best.fitness >= 0.999 * 10 * 400); // a sample without error adds the bias
    }
}

TEST_CASE("the generations are the same bit for bit, however the window is divided among evaluators") {
    auto record = line_record(20);
    SearchSettings settings;
    settings.population = 30;
    SearchResult whole = run_traditional(*line, record, settings, RandomStream(9, "parts"));

    RandomStream deal(1, "deal");
    Search search(8, settings, RandomStream(9, "parts"));
    SlidingWindow window(settings.window);
    std::size_t estimate = 0;
    for (const Sample& sample : record) {
        window.push(sample);
        if (!window.ready())
            continue;
        for (int trial = 0; trial < 5; ++trial)
            search.next_generation(evaluate_in_parts(search.population(), window.samples(), 400, deal));
        CHECK(search.best() == whole.estimates.at(estimate++).best);
    }
    CHECK(search.population() == whole.population);
}

TEST_CASE("the same stream gives the same run, and another stream another run") {
    auto record = line_record(12);
    auto run = [&](std::uint64_t seed) { return run_traditional(*line, record, {}, RandomStream(seed, "same")); };
    CHECK(run(1).population == run(1).population);
    CHECK(run(1).population != run(2).population);
}

TEST_CASE("odd populations and the smallest population work") {
    auto record = line_record(12);
    for (std::size_t population : {2u, 3u, 5u}) {
        SearchSettings settings;
        settings.population = population;
        CHECK(run_traditional(*line, record, settings, RandomStream(1, "small")).population.size() == population);
    }
}

TEST_CASE("a search that cannot run is refused with the reason") {
    auto record = line_record(8);
    auto message = [&](const SearchSettings& settings, const char* expected) {
        CHECK_THROWS_WITH_AS(run_traditional(*line, record, settings, RandomStream(1, "why")), expected, UserError);
    };
    message({}, "the window holds 10 samples, but the record has only 8");
    SearchSettings settings;
    settings.window.length = 0;
    message(settings, "the window holds 0 samples, expected at least 1");
    settings.window.length = 8;
    settings.population = 1;
    message(settings, "the population is 1, expected at least 2: crossover needs two parents");
}
