// Tests objective problems in the library.

#include "gaprocs/islands.hpp"
#include "gaprocs/problem_registry.hpp"
#include "gaprocs/traditional.hpp"
#include "gaprocs/usual_settings.hpp"
#include "tests/gaprocs/line_problem.hpp"
#include "tests/gaprocs/objectives.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <stdexcept>

using namespace placedpar;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

double fitness_of_string(const SearchProblem& problem, const char* string) {
    return problem.fitness(Genome::from_string(string), {}, 400);
}

} // namespace

TEST_CASE("fitness is the objective, negated if it is minimised") {
    Objective least{.goal = Goal::minimise}, greatest{.goal = Goal::maximise};
    CHECK(greatest.fitness(-2.5) == -2.5);
    CHECK(least.fitness(-2.5) == 2.5);
    for (double value : {-2.5, 0.0, 1e300, -1e300}) {
        CHECK(least.value(least.fitness(value)) == value);
        CHECK(greatest.value(greatest.fitness(value)) == value);
    }
    CHECK_FALSE(std::signbit(*least.value(least.fitness(0))));
}

TEST_CASE("an objective that is not a finite number is worse than every other") {
    for (Goal goal : {Goal::minimise, Goal::maximise}) {
        Objective objective{.goal = goal};
        for (double value : {not_a_number, infinite, -infinite}) {
            CHECK(objective.fitness(value) == worst_fitness);
            CHECK_FALSE(objective.value(objective.fitness(value)));
        }
        for (double value : {1e301, -1e301})
            CHECK(objective.fitness(value) > worst_fitness);
    }
    auto cliff = maximise(Cliff{});
    CHECK(fitness_of_string(*cliff, "00") == 0);
    for (const char* string : {"01", "10", "11"})
        CHECK(fitness_of_string(*cliff, string) == worst_fitness);
}

TEST_CASE("a search in which most individuals have no finite objective continues and finds the best allowed one") {
    for (const char* reproduction : {"ranking", "scaled", "tournament"}) {
        auto cliff = minimise(Cliff{});
        SearchSettings settings = usual_settings(*cliff);
        settings.population = 9;
        settings.reproduction = Reproduction::named(reproduction);
        auto result = run_traditional(*cliff, 50, settings, RandomStream(1, "cliff"));
        CHECK(result.best().best.fitness == 0);
        CHECK(result.best().parameters == std::vector<double>{0});
    }
}

TEST_CASE("a plain struct of two functions is a problem") {
    auto sphere = minimise(PlainSphere{});
    CHECK(sphere->bits() == 24);
    CHECK(sphere->channels() == 0);
    CHECK(sphere->parameter_names() == std::vector<std::string>{"x_1", "x_2", "x_3"});
    CHECK(sphere->parameter_units() == std::vector<std::string>(3));
    CHECK(sphere->objective()->goal == Goal::minimise);
    CHECK(sphere->objective()->unit.empty());
    CHECK_FALSE(sphere->objective()->optimum);
    CHECK(sphere->decode(Genome::from_string("111111111000000000000000")) == std::vector<double>{3.96875, 0, -4});
    CHECK(fitness_of_string(*sphere, "000000001000000010000000") == -16);
    CHECK(maximise(PlainSphere{})->fitness(Genome(24), {}, 400) == 48);
    CHECK_THROWS_AS(sphere->error(Genome(24), {}), std::logic_error);
    CHECK_FALSE(make_search_problem(LineProblem{})->objective());
}

TEST_CASE("optional functions of a struct give the problem's names, units and optimum") {
    auto valley = minimise(Valley{});
    CHECK(valley->parameter_names() == std::vector<std::string>{"across", "along"});
    CHECK(valley->parameter_units() == std::vector<std::string>{"m", "km"});
    CHECK(valley->objective()->unit == "m");
    CHECK(valley->objective()->optimum == 0);
}

TEST_CASE("any problem with fields can be read in Gray code") {
    auto gray = minimise(PlainSphere{})->coded(Coding::gray);
    CHECK(gray->coding() == Coding::gray);
    CHECK(gray->decode(Genome::from_string("110000001100000011000000")) == std::vector<double>{0, 0, 0});
    CHECK(fitness_of_string(*gray, "110000001100000011000000") == 0);
    CHECK(gray->coded(Coding::natural)->decode(Genome::from_string("100000001000000010000000")) ==
          std::vector<double>{0, 0, 0});
}

TEST_CASE("the traditional algorithm finds the sphere's minimum and reports it without negation") {
    auto sphere = minimise(PlainSphere{})->coded(Coding::gray);
    SearchSettings settings = usual_settings(*sphere);
    settings.elite = 1;
    auto result = run_traditional(*sphere, 100, settings, RandomStream(1, "sphere"));
    CHECK(result.generations == 100);
    CHECK(result.estimates.size() == 100);
    CHECK(result.redraws == 0);
    CHECK(result.best().best.fitness == 0);
    CHECK(sphere->objective()->value(result.best().best.fitness) == 0);
    CHECK(result.best().parameters == std::vector<double>{0, 0, 0});
}

TEST_CASE("an objective does not depend on window, bias and trials") {
    auto sphere = minimise(PlainSphere{});
    SearchSettings usual = usual_settings(*sphere), other = usual;
    other.window = {.length = 7, .first = 3, .trials = 4, .bias = 1};
    CHECK(run_traditional(*sphere, 20, usual, RandomStream(1, "sphere")).population ==
          run_traditional(*sphere, 20, other, RandomStream(1, "sphere")).population);
    IslandsSettings islands, others;
    islands.islands.assign(3, usual);
    others.islands = {usual, other, usual};
    auto result = run_islands(*sphere, 20, islands, island_streams(1, 3));
    CHECK(result.islands[1].generations == 20);
    CHECK(result.migrations.size() == 3 * (20 / 3));
    CHECK(result.islands[1].population == run_islands(*sphere, 20, others, island_streams(1, 3)).islands[1].population);
}

TEST_CASE("roulette with a minimised objective is refused with the reason") {
    auto sphere = minimise(PlainSphere{});
    for (const char* reproduction : {"roulette", "universal"}) {
        SearchSettings settings;
        settings.reproduction = Reproduction::named(reproduction);
        CHECK_THROWS_WITH_AS(run_traditional(*sphere, 20, settings, RandomStream(1, "sphere")),
                             doctest::Contains("expected ranking, scaled or tournament"), UserError);
        IslandsSettings islands;
        islands.islands.assign(3, settings);
        CHECK_THROWS_AS(run_islands(*sphere, 20, islands, island_streams(1, 3)), UserError);
        CHECK_NOTHROW(run_traditional(*maximise(PlainSphere{}), 20, settings, RandomStream(1, "sphere")));
    }
    CHECK(usual_settings(*sphere).reproduction.text() == "ranking(best = 2)");
    CHECK(usual_settings(*make_search_problem(LineProblem{})).reproduction.text() == "roulette");
}

TEST_CASE("zero generations are refused") {
    CHECK_THROWS_WITH_AS(run_traditional(*maximise(PlainSphere{}), 0, {}, RandomStream(1, "sphere")),
                         "the number of generations is 0, expected at least 1", UserError);
    CHECK_THROWS_AS(SearchResult{}.best(), std::logic_error);
}

TEST_CASE("a problem of a family is found by name and numbers, and made once") {
    ProblemRegistry registry;
    registry.add("line", make_search_problem(LineProblem{}), line_record(3));
    registry.add("sphere", minimise(PlainSphere{}));
    registry.add(minimised<Valley>());
    CHECK(registry.names() == std::vector<std::string>{"line", "sphere", "valley"});
    CHECK(registry.families().at(0).text() == "valley(dimensions = 2, low = -1)");
    CHECK(registry.find("sphere").samples() == 0);
    CHECK(registry.find("valley").problem()->bits() == 8);
    CHECK(registry.find("valley(3)").problem()->bits() == 12);
    CHECK(registry.find("valley(low = -3, dimensions = 4)").problem()->decode(Genome(16)).front() == -3);
    CHECK(&registry.find("valley(2)") == &registry.find(" valley ( dimensions = 2, low = -1 )"));
}

TEST_CASE("a problem with a name and no numbers is a family of one problem") {
    ProblemRegistry registry;
    registry.add(minimised<Bowl>());
    CHECK(registry.families().at(0).text() == "bowl");
    CHECK(registry.find("bowl").problem()->bits() == 6);
    CHECK_THROWS_AS(registry.find("bowl(1)"), UserError);
}

TEST_CASE("a problem that does not exist, or not with these numbers, is refused with a list of what exists") {
    ProblemRegistry registry;
    registry.add("sphere", minimise(PlainSphere{}));
    registry.add(minimised<Valley>());
    auto refusal = [&](const char* name) -> std::string {
        try {
            registry.find(name);
        } catch (const UserError& refused) {
            return refused.what();
        }
        return "";
    };
    CHECK(refusal("valey") == "unknown search problem 'valey'; known: sphere, valley; did you mean \"valley\"?");
    CHECK(refusal("hill(3)") == "unknown search problem 'hill(3)'; known: sphere, valley");
    CHECK(refusal("valley(10)") == "dimensions = 10 is out of range: dimensions is a whole number from 1 to 9");
    CHECK(refusal("valley(depth = 1)").find("valley has no number \"depth\"") == 0);
    CHECK(refusal("valley(low = 1)") == "search problem 'valley(dimensions = 2, low = 1)': parameter 0: the range is "
                                        "1 to 1, expected two finite numbers, the lower number first");
    CHECK(refusal("sphere(3)") == "unknown search problem 'sphere(3)'; known: sphere, valley; did you mean "
                                  "\"sphere\"?");
}

TEST_CASE("a record for an objective problem, and a repeated name, are refused") {
    ProblemRegistry registry;
    CHECK_THROWS_WITH_AS(registry.add("sphere", minimise(PlainSphere{}), {{}}),
                         "search problem 'sphere': an objective problem has no record", std::invalid_argument);
    registry.add(minimised<Valley>());
    CHECK_THROWS_WITH_AS(registry.add(maximised<Valley>()), "a search problem named 'valley' exists already",
                         std::invalid_argument);
    CHECK_THROWS_AS(registry.add("valley", minimise(PlainSphere{})), std::invalid_argument);
}
