#include "bench/rastrigin/contest.hpp"
#include "gaprocs/objective_problem.hpp"
#include "gaprocs/traditional.hpp"
#include "gaprocs/usual_settings.hpp"

#include <memory>

namespace placedpar {

namespace {

/// The problem for our search. The optimum is exactly one of the codes.
struct Descent {
    Valley* valley;

    ParameterCoding representation() const { return {Valley::dimensions, {Valley::low, Valley::high, 24}}; }
    double objective(std::span<const double> x) const { return valley->objective(x); }
};

void descend(Valley& valley, std::uint64_t seed, const SearchProblem& problem, const SearchSettings& settings) {
    std::size_t generations = valley.most_evaluations() / settings.population + 1;
    run_traditional(problem, generations, settings, RandomStream(seed, "search"));
}

std::shared_ptr<const SearchProblem> problem_of(Valley& valley, Coding coding) {
    return minimise(Descent{&valley})->coded(coding);
}

/// Uses settings for a problem about which nothing is known: an elite, and mutations of every size.
void usual(Valley& valley, std::uint64_t seed) {
    auto problem = problem_of(valley, Coding::real);
    SearchSettings settings = usual_settings(*problem);
    settings.elite = 1;
    settings.mutation = BreederMutation{};
    settings.mutation_probability = 1.0 / Valley::dimensions;
    descend(valley, seed, *problem, settings);
}

void reals(Valley& valley, std::uint64_t seed) {
    auto problem = problem_of(valley, Coding::real);
    SearchSettings settings;
    settings.population = 10;
    settings.elite = 1;
    settings.reproduction = TournamentReproduction{.size = 3};
    settings.crossover = UniformCrossover{};
    settings.mutation = BreederMutation{.range = 0.5};
    settings.mutation_probability = 1.0 / Valley::dimensions;
    descend(valley, seed, *problem, settings);
}

void bits(Valley& valley, std::uint64_t seed, Coding coding) {
    auto problem = problem_of(valley, coding);
    SearchSettings settings;
    settings.population = 20;
    settings.elite = 1;
    settings.reproduction = TournamentReproduction{.size = 3};
    settings.crossover = UniformCrossover{};
    settings.mutation = DistanceMutation{};
    settings.mutation_probability = 2.0 / static_cast<double>(problem->bits());
    descend(valley, seed, *problem, settings);
}

void gray(Valley& valley, std::uint64_t seed) { bits(valley, seed, Coding::gray); }
void natural(Valley& valley, std::uint64_t seed) { bits(valley, seed, Coding::natural); }

} // namespace

std::vector<Contestant> ours() {
    return {{"PlacedPar, real numbers", reals},
            {"... usual settings, 120", usual},
            {"... Gray code, 24 bits each", gray},
            {"... natural code", natural}};
}

} // namespace placedpar
