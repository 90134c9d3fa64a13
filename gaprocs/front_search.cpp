#include "gaprocs/front_search.hpp"

#include "gaprocs/merit.hpp"
#include "gaprocs/search.hpp"
#include "gaprocs/search_progress.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <set>
#include <utility>

namespace placedpar {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Evaluates generations, and keeps the merits of the survivors.
class FrontEvaluation {
public:
    explicit FrontEvaluation(const SearchProblem& problem) : problem_(problem) {}

    /// Returns the merits of a population whose first individuals are the survivors of the generation before.
    const std::vector<Merit>& evaluate(const std::vector<Genome>& population) {
        const auto offspring = std::span(population).subspan(merits_.size());
        std::ranges::copy(problem_.merits(offspring), std::back_inserter(merits_));
        evaluations_ += offspring.size();
        std::set<std::vector<std::uint64_t>> seen;
        for (std::size_t i = 0; i < population.size(); ++i)
            if (!seen.emplace(population[i].words().begin(), population[i].words().end()).second)
                merits_[i] = {.feasible = false, .costs = {}, .violation = infinite};
        return merits_;
    }
    /// Keeps the merits of the survivors, in the order in which the search copies them.
    void keep(const std::vector<std::size_t>& survivors) {
        std::vector<Merit> kept;
        for (std::size_t each : survivors)
            kept.push_back(std::move(merits_[each]));
        merits_ = std::move(kept);
    }
    std::uint64_t evaluations() const { return evaluations_; }

private:
    const SearchProblem& problem_;
    std::vector<Merit> merits_;
    std::uint64_t evaluations_ = 0;
};

FrontIndividual front_individual(const SearchProblem& problem, const Genome& genome, const Merit& merit) {
    FrontIndividual individual{genome, problem.decode(genome), merit.costs};
    if (problem.objective()->goal == Goal::maximise)
        for (double& cost : individual.objectives)
            cost = 0 - cost;
    return individual;
}

/// Adds the front of the survivors to the result.
void take_survivors(FrontResult& result, const SearchProblem& problem, const std::vector<Genome>& population,
                    const std::vector<Merit>& merits, std::size_t survivors) {
    std::vector<Merit> surviving;
    std::vector<std::size_t> order = order_of(merits);
    order.resize(survivors);
    for (std::size_t each : order)
        surviving.push_back(merits[each]);
    result.least_violation = surviving.front().violation;
    for (std::size_t each : front_of(surviving))
        result.front.push_back(front_individual(problem, population[order[each]], surviving[each]));
}

} // namespace

SearchSettings front_settings(const Representation& representation, std::size_t population) {
    SearchSettings settings;
    settings.population = population;
    settings.elite = population / 2;
    settings.reproduction = UniversalReproduction{};
    settings.crossover = UniformCrossover{};
    settings.crossover_probability = 0.9;
    settings.mutation_probability =
        static_cast<double>(representation.unit()) / static_cast<double>(representation.bits());
    if (representation.kind() == StringKind::real) {
        settings.crossover = SimulatedBinaryCrossover{};
        settings.mutation = PolynomialMutation{};
    }
    if (representation.kind() == StringKind::permutation) {
        settings.crossover = OrderCrossover{};
        settings.mutation = InversionMutation{};
    }
    return settings;
}

std::vector<double> front_fitness(std::span<const Merit> merits) {
    std::vector<std::size_t> order = order_of(merits);
    std::vector<double> fitness(merits.size());
    for (std::size_t place = 0, half = merits.size() / 2; place < half; ++place)
        fitness[order[place]] = static_cast<double>(half - place);
    return fitness;
}

FrontResult search_front(const SearchProblem& problem, std::size_t generations, const SearchSettings& settings,
                         RandomStream random, const std::function<void(std::uint64_t)>& after_generation,
                         Checkpoints* checkpoints) {
    if (!problem.objective())
        throw UserError("a problem with a record has no front: expected a problem with objectives");
    if (generations == 0)
        throw UserError("the number of generations is 0, expected at least 1");
    if (settings.elite == 0 || settings.elite != settings.population / 2)
        throw UserError(fmt::format(
            "the elite has {} of {} individuals, expected {}: in a search for a front, the better half survives",
            settings.elite, settings.population, settings.population / 2));
    Search search(problem.representation(), settings, std::move(random));
    SearchProgress progress(search, "front", checkpoints);
    FrontEvaluation evaluation(problem);
    FrontResult result;
    result.generations = generations;
    for (std::size_t generation = 1; generation < generations; ++generation) {
        if (progress.passes_over())
            continue;
        progress.note_population(search);
        const std::vector<double> fitness = front_fitness(evaluation.evaluate(search.population()));
        evaluation.keep(best_indices(fitness, settings.elite));
        search.next_generation(fitness);
        progress.note_best(search);
        progress.keep(search);
        if (after_generation)
            after_generation(generation);
    }
    progress.require_passed(search);
    take_survivors(result, problem, search.population(), evaluation.evaluate(search.population()), settings.elite);
    if (after_generation)
        after_generation(generations);
    result.evaluations = evaluation.evaluations();
    return result;
}

} // namespace placedpar
