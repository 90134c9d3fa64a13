// Tests that invalid requests are refused.

#include "gaprocs/islands.hpp"
#include "gaprocs/objective_problem.hpp"
#include "gaprocs/problem_registry.hpp"
#include "gaprocs/traditional.hpp"
#include "gaprocs/usual_settings.hpp"
#include "tests/gaprocs/cluster.hpp"
#include "tests/gaprocs/objectives.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

using namespace placedpar;

namespace {

/// A problem whose bounds are reversed by default, and whose fields may have 0 bits.
struct Reversed {
    std::size_t bits = 4;
    double low = 5, high = -5;
    ParameterCoding representation() const { return ParameterCoding(2, {low, high, bits}); }
    double objective(std::span<const double> x) const { return x[0]; }
};

/// Returns the error message of a search of the sphere with changed settings.
std::string refusal_of_settings(void (*change)(SearchSettings&)) {
    auto sphere = minimise(PlainSphere{});
    SearchSettings settings = usual_settings(*sphere);
    change(settings);
    try {
        run_traditional(*sphere, 3, settings, RandomStream(1, "bad"));
    } catch (const UserError& refused) {
        return refused.what();
    }
    return "";
}

/// Returns the error message of a netlist whose master has these parameters.
std::string refusal_of_master(const std::string& parameters) {
    Cluster cluster{.slaves = 0, .population = 30, .master_parameters = "rehearsals = 0, " + parameters};
    try {
        run_on_line(cluster.netlist());
    } catch (const std::runtime_error& refused) {
        return refused.what();
    }
    return "";
}

bool mentions(const std::string& text, const std::string& part) {
    CAPTURE(text);
    CAPTURE(part);
    bool found = text.find(part) != text.npos;
    CHECK(found);
    return found;
}

} // namespace

TEST_CASE("reversed bounds and zero bits are refused when the problem is made") {
    CHECK_THROWS_WITH_AS(minimise(Reversed{}),
                         "parameter 0: the range is 5 to -5, expected two finite numbers, the lower number first",
                         std::invalid_argument);
    CHECK_THROWS_WITH_AS(minimise(Reversed{.bits = 0, .low = -5, .high = 5}), "parameter 0: 0 bits, expected 1 to 52",
                         std::invalid_argument);
    CHECK_THROWS_AS(Search(0, {}, RandomStream(1, "bad")), std::invalid_argument);
}

TEST_CASE("populations of 0 and 1 are refused") {
    CHECK(refusal_of_settings([](SearchSettings& s) { s.population = 0; }) ==
          "the population is 0, expected at least 2: crossover needs two parents");
    CHECK(refusal_of_settings([](SearchSettings& s) { s.population = 1; }) ==
          "the population is 1, expected at least 2: crossover needs two parents");
    CHECK(refusal_of_settings([](SearchSettings& s) { s.population = 2; }).empty());
    for (int population : {0, 1}) {
        Cluster cluster{.slaves = 0, .population = population};
        CHECK_THROWS_WITH(run_on_line(cluster.netlist()),
                          doctest::Contains("the parameter \"population\" is out of range"));
    }
}

TEST_CASE("probabilities outside 0 to 1 are refused") {
    CHECK(refusal_of_settings([](SearchSettings& s) { s.mutation_probability = -0.1; }) ==
          "the mutation probability is -0.1, expected 0 to 1");
    CHECK(refusal_of_settings([](SearchSettings& s) { s.crossover_probability = 1.5; }) ==
          "the crossover probability is 1.5, expected 0 to 1");
    CHECK(refusal_of_settings([](SearchSettings& s) { s.mutation_probability = std::nan(""); }) ==
          "the mutation probability is nan, expected 0 to 1");
    mentions(refusal_of_master("mutation = 1.5"), "the parameter \"mutation\" is out of range: 1.5");
    mentions(refusal_of_master("crossover = -0.5"), "the parameter \"crossover\" is out of range: -0.5");
}

TEST_CASE("a window longer than the record is refused by the library and before a netlist runs") {
    SearchSettings settings;
    settings.window.length = 13;
    CHECK_THROWS_WITH_AS(
        run_traditional(*make_search_problem(LineProblem{}), line_record(12), settings, RandomStream(1, "bad")),
        "the window holds 13 samples, but the record has only 12", UserError);
    mentions(refusal_of_master("window = 13"),
             "error: the window holds 13 samples, but the record of \"line\" has only 12");
}

TEST_CASE("a policy's number out of range is refused, also in a policy that was made as a struct") {
    CHECK(refusal_of_settings([](SearchSettings& s) { s.reproduction = RankingReproduction{.best = 5}; }) ==
          "best = 5 is out of range: best is a number from 1 to 2");
    CHECK(refusal_of_settings([](SearchSettings& s) { s.reproduction = RankingReproduction{.best = std::nan("")}; }) ==
          "best = nan is out of range: best is a number from 1 to 2");
    CHECK(refusal_of_settings([](SearchSettings& s) { s.reproduction = TournamentReproduction{.size = 0}; }) ==
          "size = 0 is out of range: size is a whole number from 1 to 1000000");
    mentions(refusal_of_master("reproduction = \"ranking(5)\""), "best = 5 is out of range");
    auto sphere = minimise(PlainSphere{});
    IslandsSettings settings;
    settings.islands.assign(2, usual_settings(*sphere));
    settings.emigration = BestEmigration{.count = 0};
    CHECK_THROWS_WITH_AS(run_islands(*sphere, 3, settings, island_streams(1, 2)),
                         "count = 0 is out of range: count is a whole number from 1 to 1000000", UserError);
}

TEST_CASE("a sample with too few numbers is refused before the search begins") {
    auto line = make_search_problem(LineProblem{});
    auto record = line_record(12);
    record[7].pop_back();
    CHECK_THROWS_WITH_AS(run_traditional(*line, record, SearchSettings(), RandomStream(1, "bad")),
                         "sample 7 has 1 number, expected 2", std::invalid_argument);
    IslandsSettings settings;
    settings.islands.assign(2, SearchSettings());
    CHECK_THROWS_WITH_AS(run_islands(*line, record, settings, island_streams(1, 2)),
                         "sample 7 has 1 number, expected 2", std::invalid_argument);
}

TEST_CASE("a sample that is infinite or not a number gives the worst fitness, and the search continues") {
    auto line = make_search_problem(LineProblem{});
    auto record = line_record(12);
    for (double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
        record.back().front() = bad;
        auto result = run_traditional(*line, record, SearchSettings(), RandomStream(1, "bad"));
        CHECK(result.estimates.back().best.fitness < 0);
        CHECK(std::isfinite(result.estimates.back().best.fitness));
    }
}

TEST_CASE("reversed bounds and zero bits of a user-defined problem are a UserError with the problem's name") {
    ProblemRegistry problems;
    auto make = [](const std::vector<double>& numbers) {
        return minimise(Reversed{.bits = static_cast<std::size_t>(numbers[0])});
    };
    problems.add(ProblemFamily{{"own", "", {{"bits", 4, 0, 9, true}}}, make});
    CHECK_THROWS_WITH_AS(problems.find("own"),
                         "search problem 'own(bits = 4)': parameter 0: the range is 5 to -5, expected two finite "
                         "numbers, the lower number first",
                         UserError);
    CHECK_THROWS_WITH_AS(problems.find("own(0)"),
                         "search problem 'own(bits = 0)': parameter 0: 0 bits, expected 1 to 52", UserError);
}

TEST_CASE("an odd population works with every kind of string") {
    for (const auto& problem : {minimise(PlainSphere{}), minimise(PlainSphere{})->coded(Coding::real),
                                minimise(Seats{}), minimise(Plane{}), make_search_problem(LineProblem{})}) {
        SearchSettings settings = usual_settings(*problem);
        settings.window = {.length = 1, .first = 1, .trials = 1};
        for (std::size_t population : {3u, 31u}) {
            settings.population = population;
            auto record = problem->objective() ? empty_record(12) : line_record(12);
            auto result = run_traditional(*problem, record, settings, RandomStream(1, "odd"));
            CHECK(result.population.size() == population);
            CHECK(result.generations == 12);
        }
    }
}

TEST_CASE("a genome of 4096 bits is searched") {
    auto comb = maximise(Comb{});
    SearchSettings settings = usual_settings(*comb);
    settings.elite = 1;
    settings.mutation_probability = 1.0 / 4096;
    auto result = run_traditional(*comb, 60, settings, RandomStream(1, "comb"));
    CHECK(result.estimates.front().best.fitness < 2200);
    CHECK(result.best().best.fitness > 2400);
}

TEST_CASE("a search in which no individual has a finite objective continues and finds no solution") {
    auto nowhere = minimise(Nowhere{});
    for (const char* reproduction : {"ranking", "scaled", "tournament"}) {
        SearchSettings settings = usual_settings(*nowhere);
        settings.reproduction = Reproduction::named(reproduction);
        auto result = run_traditional(*nowhere, 5, settings, RandomStream(1, "nowhere"));
        CHECK(result.best().best.fitness == worst_fitness);
        CHECK_FALSE(nowhere->objective()->value(result.best().best.fitness));
    }
    SearchSettings roulette;
    auto result = run_traditional(*maximise(Nowhere{}), 5, roulette, RandomStream(1, "nowhere"));
    CHECK(result.redraws == 5);
}
