#pragma once

#include "gaprocs/policies/crossover.hpp"
#include "gaprocs/policies/mutation.hpp"
#include "gaprocs/policies/reproduction.hpp"
#include "gaprocs/representation/genome.hpp"
#include "gaprocs/settings.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace placedpar {

struct Individual {
    Genome genome;
    double fitness = 0;

    friend bool operator==(const Individual&, const Individual&) = default;
};

/// Index of the greatest (smallest) fitness; the lowest index among equals. REQUIRES: not empty.
std::size_t best_index(std::span<const double> fitness);
std::size_t worst_index(std::span<const double> fitness);
/// Indices of the `count` greatest, the greatest first; the lower index first among equals.
/// REQUIRES: count <= fitness.size().
std::vector<std::size_t> best_indices(std::span<const double> fitness, std::size_t count);

/// The state of a traditional genetic algorithm, one generation at a time. It does not evaluate: its owner (a plain
/// loop, a master with its slaves, an island) finds the fitness of population() and hands it in. The next generation
/// depends on the settings, the stream and those numbers alone, not on which process found them: so algorithm A gives
/// exactly the generations of the traditional algorithm.
///
/// The order of calls on an island: evaluate; emigrant() to the neighbour; accept() the immigrant; next_generation().
///
/// An elite (SearchSettings::elite) is copied unchanged to the head of the next population, the best first. Only the
/// strings are copied: the elite is evaluated again with all others, since its fitness changes when the window moves.
/// While the window stays, the best fitness never falls.
class Search {
public:
    /// Draws the first population. Throws std::invalid_argument for 0 bits, and as SearchSettings::validate().
    Search(std::size_t bits, const SearchSettings& settings, RandomStream random);
    /// Starts from a given population. Throws std::invalid_argument also when it is not settings.population
    /// strings of one length.
    Search(std::vector<Genome> population, const SearchSettings& settings, RandomStream random);

    const std::vector<Genome>& population() const { return population_; }
    /// Generations evaluated so far.
    std::uint64_t generation() const { return generation_; }
    /// How often no individual had positive fitness, so that the whole population but the elite was drawn anew. The
    /// thesis is silent on this case, in which no sector of the roulette wheel has any width.
    std::uint64_t redraws() const { return redraws_; }

    /// Ends the evaluated generation: remembers its best, then reproduction, crossover and mutation.
    /// Throws std::invalid_argument unless there is one finite fitness for each individual.
    void next_generation(std::span<const double> fitness);

    /// The best of the last evaluated generation, not of all time: the window, and with it fitness, moves.
    /// Throws std::logic_error before the first next_generation().
    const Individual& best() const;

    /// The best of the population with this fitness, to be sent to another island. Throws as
    /// next_generation().
    Individual emigrant(std::span<const double> fitness) const;
    /// The immigrant replaces the worst, better or not: its string in population(), its fitness in `fitness`.
    /// Throws as next_generation(), or when its string has another length.
    void accept(const Individual& immigrant, std::span<double> fitness);

private:
    void require_fitness(std::span<const double> fitness) const;

    std::size_t bits_;
    std::size_t elite_;
    Reproduction reproduction_;
    Crossover crossover_;
    double crossover_probability_;
    BitMutation mutation_;
    RandomStream random_;
    std::vector<Genome> population_;
    std::vector<Genome> offspring_; ///< the next population in the making: kept to reuse its memory
    std::optional<Individual> best_;
    std::uint64_t generation_ = 0;
    std::uint64_t redraws_ = 0;
};

} // namespace placedpar
