#include "gaprocs/search.hpp"

#include "text/counted.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>

namespace placedpar {

namespace {

/// Returns the representation of the population's strings. REQUIRES: the population is not empty.
BitString strings_of(const std::vector<Genome>& population) {
    return BitString(population.empty() ? 0 : population.front().size());
}

void require_initial_length(const Representation& representation, const Genome& genome) {
    if (genome.size() != representation.bits())
        throw UserError(fmt::format("an initial individual has {}, expected {}", counted(genome.size(), "bit"),
                                    representation.bits()));
}

} // namespace

Search::Search(Representation representation, const SearchSettings& settings, RandomStream random)
    : representation_(std::move(representation)), elite_(settings.elite), reproduction_(settings.reproduction),
      crossover_(settings.crossover), crossover_probability_(settings.crossover_probability),
      mutation_(settings.mutation), mutation_probability_(settings.mutation_probability), random_(std::move(random)),
      population_(settings.initial) {
    settings.validate();
    require_fitting_operators(representation_, settings);
    for (const Genome& genome : population_)
        require_initial_length(representation_, genome);
    while (population_.size() < settings.population)
        population_.push_back(representation_.random(random_));
}

Search::Search(std::vector<Genome> population, const SearchSettings& settings, RandomStream random)
    : representation_(strings_of(population)), elite_(settings.elite), reproduction_(settings.reproduction),
      crossover_(settings.crossover), crossover_probability_(settings.crossover_probability),
      mutation_(settings.mutation), mutation_probability_(settings.mutation_probability), random_(std::move(random)),
      population_(std::move(population)) {
    settings.validate();
    require_fitting_operators(representation_, settings);
    if (population_.size() != settings.population)
        throw std::invalid_argument(fmt::format("the given population has {}, expected {}",
                                                counted(population_.size(), "string"), settings.population));
    for (const Genome& genome : population_)
        if (genome.size() != representation_.bits())
            throw std::invalid_argument(
                fmt::format("the population has strings of {} bits and of {}, expected equal lengths",
                            representation_.bits(), counted(genome.size(), "bit")));
}

bool Search::is_valid(const Individual& individual) const {
    return representation_.holds({&individual.genome, 1}) && std::isfinite(individual.fitness);
}

void Search::go_on_from(SearchState state) {
    const bool fits = state.population.size() == population_.size() && representation_.holds(state.population) &&
                      (!state.best || is_valid(*state.best));
    if (!fits)
        throw UserError(fmt::format("the checkpoint belongs to another search: expected {} of this search's "
                                    "representation, with a finite best fitness",
                                    counted(population_.size(), "string")));
    generation_ = state.generation;
    redraws_ = state.redraws;
    random_.go_to(state.drawn);
    population_ = std::move(state.population);
    best_ = std::move(state.best);
}

void Search::next_generation(std::span<const double> fitness) {
    require_fitness(fitness);
    if (listener_)
        listener_(*this, fitness);
    remember_best(fitness);
    ++generation_;
    offspring_.resize(population_.size());
    auto next = offspring_.begin();
    for (std::size_t index : best_indices(fitness, elite_))
        *next++ = population_[index];
    const auto bred = std::span(offspring_).subspan(static_cast<std::size_t>(next - offspring_.begin()));
    if (auto parents = reproduction_(fitness, bred.size(), random_)) {
        for (std::size_t parent : *parents)
            *next++ = population_[parent];
        crossover_(bred, crossover_probability_, representation_, random_);
        mutation_(bred, mutation_probability_, representation_, random_);
    } else {
        ++redraws_;
        for (Genome& genome : bred)
            genome = representation_.random(random_);
    }
    std::swap(population_, offspring_);
}

void Search::remember_best(std::span<const double> fitness) {
    std::size_t best = best_index(fitness);
    if (!best_)
        best_.emplace();
    best_->genome = population_[best]; // reuses the memory
    best_->fitness = fitness[best];
}

const Individual& Search::best() const {
    if (!best_)
        throw std::logic_error("no generation has been evaluated yet, so there is no best individual");
    return *best_;
}

std::vector<Individual> Search::emigrants(std::span<const double> fitness, const Emigration& emigration) {
    require_fitness(fitness);
    std::vector<Individual> leaving;
    for (std::size_t index : emigration(fitness, random_))
        leaving.push_back({population_[index], fitness[index]});
    return leaving;
}

Places Search::accept(std::span<const Individual> immigrants, std::span<double> fitness, const Acceptance& acceptance) {
    require_fitness(fitness);
    for (const Individual& immigrant : immigrants)
        require_length(immigrant);
    Places places = acceptance({population_, fitness, elite_, &representation_}, immigrants, random_);
    for (std::size_t i = 0; i < places.size(); ++i)
        if (auto place = places[i]) {
            population_[*place] = immigrants[i].genome;
            fitness[*place] = immigrants[i].fitness;
        }
    return places;
}

Places Search::accept_among_offspring(std::span<const Individual> immigrants) {
    for (const Individual& immigrant : immigrants)
        require_length(immigrant);
    Places places = Acceptance(OffspringAcceptance{})({population_, {}, elite_}, immigrants, random_);
    for (std::size_t i = 0; i < places.size(); ++i)
        population_[places[i].value()] = immigrants[i].genome;
    return places;
}

void Search::require_length(const Individual& immigrant) const {
    if (immigrant.genome.size() != representation_.bits())
        throw std::invalid_argument(fmt::format("an immigrant has {}, but the island's strings have {}",
                                                counted(immigrant.genome.size(), "bit"),
                                                counted(representation_.bits(), "bit")));
}

void Search::require_fitness(std::span<const double> fitness) const {
    if (fitness.size() != population_.size())
        throw std::invalid_argument(
            fmt::format("{} fitness values were given for a population of {}", fitness.size(), population_.size()));
    for (std::size_t i = 0; i < fitness.size(); ++i)
        if (!std::isfinite(fitness[i]))
            throw std::invalid_argument(
                fmt::format("the fitness of individual {} is {}, expected a finite number", i, fitness[i]));
}

} // namespace placedpar
