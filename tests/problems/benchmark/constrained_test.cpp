#include "gaprocs/front_search.hpp"
#include "gaprocs/objective_problem.hpp"
#include "problems/benchmark/constrained.hpp"
#include "problems/benchmark/fronts.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace placedpar;

namespace {

/// Checks that the published best point is feasible and has the published value (J. Liang and others, 2006; the points
/// are printed to ten digits or more).
template <class Problem>
void check_best(const std::vector<double>& x, double tolerance) {
    const Problem problem;
    CAPTURE(Problem::name);
    REQUIRE(x.size() == problem.representation().parameters());
    CHECK(std::abs(problem.objective(x) - problem.optimum()) <= tolerance * std::abs(problem.optimum()));
    CHECK(std::ranges::max(problem.constraints(x)) <= 1e-6);
    for (std::size_t i = 0; i < x.size(); ++i)
        CHECK((x[i] >= Problem::ranges()[i].low && x[i] <= Problem::ranges()[i].high));
}

/// Returns the mean over ten seeds of the mean distance g - 1 of a front, with 200 individuals and 100 generations.
template <class Problem>
double distance_after_20200_evaluations() {
    const auto problem = minimise(Problem{})->coded(Coding::real);
    SearchSettings settings = front_settings(problem->representation(), 400);
    settings.crossover = SimulatedBinaryCrossover{20};
    double sum = 0;
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        const FrontResult found = search_front(*problem, 100, settings, RandomStream(seed, Problem::name));
        REQUIRE(found.evaluations == 20200);
        for (const FrontIndividual& each : found.front)
            sum += (Problem::distance(std::span(each.parameters).subspan(1)) - 1) /
                   static_cast<double>(found.front.size());
    }
    return sum / 10;
}

} // namespace

TEST_CASE("the published optima of G01 to G06 are feasible and have the published values") {
    check_best<G01>({1, 1, 1, 1, 1, 1, 1, 1, 1, 3, 3, 3, 1}, 1e-15);
    check_best<G02>({3.16246061572185, 3.12833142812967, 3.09479212988791, 3.06145059523469, 3.02792915885555,
                     2.99382606701730, 2.95866871765285, 2.92184227312450, 0.49482511456933, 0.48835711005490,
                     0.48231642711865, 0.47664475092742, 0.47129550835493, 0.46623099264167, 0.46142004984199,
                     0.45683664767217, 0.45245876903267, 0.44826762241853, 0.44424700958760, 0.44038285956317},
                    1e-6);
    check_best<G03>(std::vector<double>(10, std::sqrt(1.0001 / 10)), 1e-7);
    check_best<G04>({78, 33, 29.9952560256815985, 45, 36.7758129057882073}, 1e-9);
    check_best<G05>({679.945148297028709, 1026.06697600004691, 0.118876369094410433, -0.39623348521517826}, 1e-9);
    check_best<G06>({14.09500000000000064, 0.8429607892154795668}, 1e-9);
}

TEST_CASE("the fronts of ZDT1 to 4 have their published form, and nothing is below") {
    const std::vector<double> quarter{0.25, 0, 0, 0, 0};
    CHECK(Zdt1{}.objectives(quarter) == std::vector<double>{0.25, 0.5});
    CHECK(Zdt2{}.objectives(quarter) == std::vector<double>{0.25, 1 - 0.0625});
    CHECK(Zdt3{}.objectives(quarter)[1] == doctest::Approx(0.5 - 0.25));
    CHECK(Zdt4{}.objectives(quarter) == std::vector<double>{0.25, 0.5});
    CHECK(Zdt1{}.objectives(std::vector<double>{0.25, 1, 1})[1] == doctest::Approx(10 * (1 - std::sqrt(0.025))));
    CHECK(Zdt4{}.objectives(std::vector<double>{1, 0.5})[1] == doctest::Approx(1.25 * (1 - std::sqrt(1 / 1.25))));
}

TEST_CASE("fronts are as near as pagmo's documentation states for its NSGA-II with equal settings and evaluations") {
    // "Benchmarking Nondominated Sorting Particle Swarm Optimizer (NSPSO) on ZDT1 and ZDT2 problems", pygmo 2: means of
    // ten runs 0.011525 +- 0.001534 and 0.009290 +- 0.001335. The bounds are three standard errors of the difference.
    CHECK(std::abs(distance_after_20200_evaluations<Zdt1>() - 0.011525) < 0.0020);
    CHECK(std::abs(distance_after_20200_evaluations<Zdt2>() - 0.009290) < 0.0018);
}

TEST_CASE("a front search on ZDT1 comes near the front, everywhere") {
    const auto problem = minimise(Zdt1{})->coded(Coding::real);
    const FrontResult found =
        search_front(*problem, 249, front_settings(problem->representation(), 200), RandomStream(1, "zdt1"));
    CHECK(found.evaluations == 25000);
    REQUIRE(found.front.size() == 100);
    double before = 0;
    for (const FrontIndividual& each : found.front) {
        CHECK(std::abs(each.objectives[1] - (1 - std::sqrt(each.objectives[0]))) < 0.02);
        CHECK(each.objectives[0] - before < 0.05);
        before = each.objectives[0];
    }
    CHECK(before > 0.95);
}
