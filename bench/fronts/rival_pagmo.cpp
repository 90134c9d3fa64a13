// This program makes the searches of fronts.cpp with pagmo, and uses nothing of PlacedPar. For the fronts, it runs
// `nsga2`, with the operators of PlacedPar ("pagmo") or with pagmo's defaults ("pagmo-defaults"). For the constraints,
// it runs the ant colony `gaco` ("pagmo") or `cstrs_self_adaptive` with differential evolution ("pagmo-adaptive").
//
// usage: fronts_pagmo SEEDS FRONT_EVALUATIONS CONSTRAINED_EVALUATIONS

#include <pagmo/algorithm.hpp>
#include <pagmo/algorithms/cstrs_self_adaptive.hpp>
#include <pagmo/algorithms/de.hpp>
#include <pagmo/algorithms/gaco.hpp>
#include <pagmo/algorithms/nsga2.hpp>
#include <pagmo/problems/cec2006.hpp>
#include <pagmo/problems/zdt.hpp>
#include <pagmo/utils/multi_objective.hpp>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace {

constexpr unsigned survivors = 100;

void print_front(const char* program, unsigned number, unsigned seed, const pagmo::population& population) {
    const auto values = population.get_f();
    for (auto i : pagmo::non_dominated_front_2d(values))
        std::printf("%s zdt%u %u %.17g %.17g\n", program, number, seed, values[i][0], values[i][1]);
}

void search_front(unsigned number, unsigned dimensions, unsigned seed, unsigned generations) {
    const pagmo::problem problem{pagmo::zdt(number, dimensions)};
    const pagmo::population begin(problem, survivors, seed);
    print_front("pagmo", number, seed,
                pagmo::algorithm(pagmo::nsga2(generations, 0.9, 15., 1. / dimensions, 20., seed)).evolve(begin));
    print_front("pagmo-defaults", number, seed,
                pagmo::algorithm(pagmo::nsga2(generations, 0.95, 10., 0.01, 50., seed)).evolve(begin));
}

void print_best(const char* program, unsigned number, unsigned seed, pagmo::algorithm search,
                const pagmo::population& begin) {
    search.set_seed(seed);
    const pagmo::population population = search.evolve(begin);
    pagmo::vector_double best;
    for (const auto& each : population.get_f())
        if (population.get_problem().feasibility_f(each) && (best.empty() || each[0] < best[0]))
            best = each;
    if (best.empty())
        std::printf("%s g%02u %u not feasible\n", program, number, seed);
    else
        std::printf("%s g%02u %u %.17g\n", program, number, seed, best[0]);
}

void search_constrained(unsigned number, unsigned seed, unsigned generations) {
    pagmo::problem problem{pagmo::cec2006(number)};
    pagmo::vector_double tolerances(problem.get_nc(), 0.0); // equations precede inequalities
    std::fill_n(tolerances.begin(), problem.get_nec(), 1e-4);
    problem.set_c_tol(tolerances);
    const pagmo::population begin(problem, survivors, seed);
    print_best("pagmo", number, seed, pagmo::algorithm(pagmo::gaco(generations, survivors)), begin);
    print_best("pagmo-adaptive", number, seed,
               pagmo::algorithm(pagmo::cstrs_self_adaptive(generations, pagmo::de(1), seed)), begin);
}

} // namespace

int main(int count, char** argument) {
    const auto number = [&](int i) {
        return count == 4 ? static_cast<unsigned>(std::strtoul(argument[i], nullptr, 10)) : 0U;
    };
    if (number(1) < 1 || number(2) < 2 * survivors || number(3) < 2 * survivors) {
        std::fprintf(stderr, "usage: fronts_pagmo SEEDS FRONT_EVALUATIONS CONSTRAINED_EVALUATIONS, each number of "
                             "evaluations at least 200\n");
        return 1;
    }
    for (unsigned problem = 1; problem <= 4; ++problem)
        for (unsigned seed = 1; seed <= number(1); ++seed)
            search_front(problem, problem == 4 ? 10 : 30, seed, number(2) / survivors - 1);
    for (unsigned problem = 1; problem <= 6; ++problem)
        for (unsigned seed = 1; seed <= number(1); ++seed)
            search_constrained(problem, seed, number(3) / survivors - 1);
}
