// Tests constraints, several objectives, and what the headers say of individuals without a usable value.

#include "gaprocs/front_search.hpp"
#include "gaprocs/merit.hpp"
#include "gaprocs/problem_registry.hpp"
#include "gaprocs/traditional.hpp"
#include "gaprocs/usual_settings.hpp"
#include "tests/gaprocs/objectives.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

using namespace placedpar;

namespace {

constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();

/// The least x that is at least `limit`; no objective is a number if x is above `known`.
struct AtLeast {
    static constexpr std::string_view name = "at-least", about = "the least number above a limit";
    double limit = 0.75, known = 2;
    static constexpr auto numbers() { return std::tuple(PolicyNumber{"limit", &AtLeast::limit, -9, 9}); }
    ParameterCoding representation() const { return ParameterCoding(1, {0, 1, 10}); }
    double objective(std::span<const double> x) const { return x[0] > known ? nan_value : x[0]; }
    std::vector<double> constraints(std::span<const double> x) const { return {limit - x[0], -1}; }
};

/// A problem of which no individual is feasible, or of which no constraint is a number.
struct Impossible {
    bool is_known = true;
    ParameterCoding representation() const { return ParameterCoding(1, {0, 1, 10}); }
    double objective(std::span<const double>) const { return 0; }
    std::vector<double> constraints(std::span<const double> x) const { return {is_known ? 1 + x[0] : nan_value}; }
};

/// Schaffer's problem: the front is 0 <= x <= 2.
struct Schaffer {
    double least = -100; ///< a constraint
    ParameterCoding representation() const { return ParameterCoding(1, {-10, 10, 20}); }
    std::vector<std::string> objective_names() const { return {"near 0", "near 2"}; }
    std::vector<double> objectives(std::span<const double> x) const { return {x[0] * x[0], (x[0] - 2) * (x[0] - 2)}; }
    std::vector<double> constraints(std::span<const double> x) const { return {least - x[0]}; }
};

/// 5 of 8 individuals are feasible. The others have objectives that are not finite numbers.
struct HalfKnown {
    ParameterCoding representation() const { return ParameterCoding(1, {0, 8, 3}); }
    std::vector<std::string> objective_names() const { return {"low", "high"}; }
    std::vector<double> objectives(std::span<const double> x) const {
        constexpr double infinite = std::numeric_limits<double>::infinity();
        return x[0] < 5 ? std::vector{x[0], -x[0]} : std::vector{x[0] < 7 ? nan_value : -infinite, infinite};
    }
};

Genome coded(const SearchProblem& problem, std::uint64_t code) {
    Genome genome(problem.bits());
    genome.set_field(0, problem.bits(), code);
    return genome;
}

double fitness_at(const SearchProblem& problem, std::uint64_t code) {
    return problem.fitness(coded(problem, code), {}, 1);
}

const Estimate best_of(const SearchProblem& problem) {
    SearchSettings settings = usual_settings(problem);
    settings.population = 20;
    static SearchResult result;
    result = run_traditional(problem, 40, settings, RandomStream(1, "constraints"));
    return result.best();
}

FrontResult front_of_schaffer(const Schaffer& schaffer, Coding coding, std::size_t generations) {
    const auto problem = minimise(schaffer)->coded(coding);
    return search_front(*problem, generations, front_settings(problem->representation(), 40), RandomStream(1, "front"));
}

} // namespace

TEST_CASE("the fitness follows Deb's rules: feasible before infeasible, then the objective, then the violation") {
    auto problem = minimise(AtLeast{});
    CHECK(fitness_at(*problem, 768) == -0.75);
    CHECK(fitness_at(*problem, 768) > fitness_at(*problem, 1023)); // feasible: the less, the better
    CHECK(fitness_at(*problem, 1023) > fitness_at(*problem, 767)); // feasible before infeasible
    CHECK(fitness_at(*problem, 767) > fitness_at(*problem, 766));  // infeasible: the nearer, the better
    CHECK(std::isfinite(fitness_at(*problem, 0) * 1e6));           // a population can be added up
    const Merit merit = problem->merit(coded(*problem, 512)).value();
    CHECK((!merit.feasible && merit.violation == 0.25 && merit.costs == std::vector<double>{0.5}));
    CHECK_FALSE(problem->objective()->value(fitness_at(*problem, 0)));
    CHECK(best_of(*problem).parameters == std::vector<double>{0.75});
}

TEST_CASE("a maximised problem obeys its constraints, too") {
    auto problem = maximise(AtLeast{.limit = 0.5});
    CHECK(fitness_at(*problem, 1023) > fitness_at(*problem, 512));
    CHECK(fitness_at(*problem, 512) > fitness_at(*problem, 511));
    CHECK(problem->merit(coded(*problem, 512))->costs.front() == -0.5);
}

TEST_CASE("a penalty makes the objective worse by the violation, so a small one lets infeasible individuals win") {
    auto mild = minimise(AtLeast{}, 0.5), strict = minimise(AtLeast{}, 4);
    CHECK(fitness_at(*mild, 512) == -(0.5 + 0.5 * 0.25));
    CHECK(best_of(*mild).parameters.front() < 0.1);
    CHECK(best_of(*strict).parameters == std::vector<double>{0.75});
    ProblemRegistry problems;
    problems.add(minimised<AtLeast>());
    CHECK(fitness_at(*problems.find("at-least(limit = 0.75, penalty = 0.5)").problem(), 512) == fitness_at(*mild, 512));
    CHECK(fitness_at(*problems.find("at-least").problem(), 512) < -1e300);
}

TEST_CASE("NaN is the greatest violation, and an objective that is NaN makes an individual infeasible") {
    auto problem = minimise(AtLeast{.known = 0.9});
    CHECK(fitness_at(*problem, 1023) < fitness_at(*problem, 0));
    CHECK(problem->merit(coded(*problem, 1023))->violation == std::numeric_limits<double>::infinity());
    CHECK(best_of(*problem).parameters == std::vector<double>{0.75});
    CHECK(infeasible_fitness(nan_value) == infeasible_fitness(std::numeric_limits<double>::infinity()));
    CHECK(std::isfinite(1e6 * infeasible_fitness(nan_value)));
    CHECK(infeasible_fitness(5e-324) < worst_fitness);
    CHECK(infeasible_fitness(1) > infeasible_fitness(1 + 0x1p-40));
}

TEST_CASE("a population of which no individual is feasible approaches the constraints, and says that none is") {
    auto problem = minimise(Impossible{});
    const Estimate best = best_of(*problem);
    CHECK(best.parameters == std::vector<double>{0.0});
    CHECK_FALSE(problem->objective()->value(best.best.fitness));
    CHECK(problem->merit(best.best.genome)->violation == 1);
    best_of(*minimise(Impossible{.is_known = false})); // ends
    const FrontResult none =
        search_front(*problem, 30, front_settings(problem->representation(), 40), RandomStream(1, "front"));
    CHECK(none.front.empty());
    CHECK(none.least_violation == 1);
}

TEST_CASE("a population of one individual is refused, and one of two is searched") {
    SearchSettings settings = usual_settings(*minimise(AtLeast{}));
    settings.population = 1;
    CHECK_THROWS_AS(run_traditional(*minimise(AtLeast{}), 3, settings, RandomStream(1, "one")), UserError);
    settings.population = 2;
    CHECK(run_traditional(*minimise(AtLeast{}), 3, settings, RandomStream(1, "one")).generations == 3);
    CHECK_THROWS_AS(search_front(*minimise(Schaffer{}), 3, front_settings(BitString(20), 2), RandomStream(1, "one")),
                    UserError);
}

TEST_CASE("the front of Schaffer's problem is found, within bounds and constraints, with the stated evaluations") {
    for (Coding coding :
         {Coding(Coding::natural), Coding(Coding::gray), Coding(Coding::real), Coding::named("gray(dont_care = 1)")}) {
        const FrontResult found = front_of_schaffer({}, coding, 50);
        CHECK(found.evaluations == 20 * 51);
        REQUIRE(found.front.size() == 20);
        for (const FrontIndividual& each : found.front) {
            CHECK((each.parameters[0] > -0.05 && each.parameters[0] < 2.05));
            CHECK(each.objectives == Schaffer{}.objectives(each.parameters));
        }
        CHECK(found.front.front().objectives[0] < 0.01);
        CHECK(found.front.back().objectives[1] < 0.01);
        for (const FrontIndividual& each : front_of_schaffer({.least = 1}, coding, 50).front)
            CHECK(each.parameters[0] >= 1);
    }
}

TEST_CASE("a front is found among duplicates and individuals without finite objectives") {
    const auto problem = minimise(HalfKnown{});
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        CAPTURE(seed);
        const FrontResult found =
            search_front(*problem, 30, front_settings(problem->representation(), 40), RandomStream(seed, "front"));
        REQUIRE(found.front.size() == 5);
        for (std::size_t i = 0; i < 5; ++i)
            CHECK(found.front[i].parameters.front() == static_cast<double>(i));
    }
}

TEST_CASE("equal seeds give equal fronts, and problems without objectives are refused") {
    const FrontResult one = front_of_schaffer({}, Coding::real, 9), same = front_of_schaffer({}, Coding::real, 9);
    REQUIRE(one.front.size() == same.front.size());
    for (std::size_t i = 0; i < one.front.size(); ++i)
        CHECK(one.front[i].genome == same.front[i].genome);
    auto schaffer = minimise(Schaffer{});
    CHECK_THROWS_WITH_AS(run_traditional(*schaffer, 3, usual_settings(*schaffer), RandomStream(1, "")),
                         "a problem with several objectives has no fitness: search for its front", UserError);
    CHECK_THROWS_AS(search_front(*schaffer, 0, front_settings(BitString(20), 20), RandomStream(1, "")), UserError);
}

TEST_CASE("a front search needs the better half as its elite") {
    const auto schaffer = minimise(Schaffer{});
    for (std::size_t elite : {std::size_t{0}, std::size_t{1}, std::size_t{11}}) {
        SearchSettings settings = front_settings(schaffer->representation(), 20);
        settings.elite = elite;
        CHECK_THROWS_AS(search_front(*schaffer, 3, settings, RandomStream(1, "")), UserError);
    }
}

TEST_CASE("of infeasible merits the lesser violation dominates") {
    const Merit near{.feasible = false, .costs = {9}, .violation = 1},
        far{.feasible = false, .costs = {1}, .violation = 2};
    CHECK(dominates(near, far));
    CHECK_FALSE(dominates(far, near));
    CHECK(order_of(std::vector<Merit>{far, near, {.feasible = true, .costs = {99}}}) ==
          std::vector<std::size_t>{2, 1, 0});
}
