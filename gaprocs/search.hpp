#pragma once

#include "gaprocs/policies/acceptance.hpp"
#include "gaprocs/policies/crossover.hpp"
#include "gaprocs/policies/emigration.hpp"
#include "gaprocs/policies/individual.hpp"
#include "gaprocs/policies/mutation.hpp"
#include "gaprocs/policies/reproduction.hpp"
#include "gaprocs/representation/genome.hpp"
#include "gaprocs/representation/representation.hpp"
#include "gaprocs/settings.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace placedpar {

/// The state of a traditional genetic algorithm. The search makes one generation at a time, but does not evaluate
/// individuals. Its owner (a plain loop, a master with slaves, an island) computes the fitness of population() and
/// passes it to next_generation(). The next generation depends only on the settings, the random stream and the fitness,
/// and not on the process that computed the fitness. So algorithm A gives exactly the generations of the traditional
/// algorithm.
///
/// An island calls, in this order: emigrants() after the evaluation, accept() for the immigrants, next_generation(). If
/// immigrants come among the offspring, it calls next_generation() first, then accept_among_offspring().
///
/// An elite (SearchSettings::elite) is copied unchanged to the beginning of the next population, the best individual
/// first. Only the strings are copied. The elite is evaluated again with all others, because its fitness changes when
/// the window moves. While the window stays the same, the best fitness never decreases.
class Search {
public:
    /// Takes the first individuals from SearchSettings::initial and draws the others. Throws as
    /// SearchSettings::validate(). Throws UserError for a crossover or a mutation that does not fit the representation,
    /// and for initial individuals of another length.
    Search(Representation representation, const SearchSettings& settings, RandomStream random);
    /// Makes a search of binary strings. Throws also std::invalid_argument for 0 bits.
    Search(std::size_t bits, const SearchSettings& settings, RandomStream random)
        : Search(BitString(bits), settings, std::move(random)) {}
    /// Starts from a given population of binary strings. Throws std::invalid_argument also if the population does not
    /// have settings.population strings, or if its strings have different lengths.
    Search(std::vector<Genome> population, const SearchSettings& settings, RandomStream random);

    const Representation& representation() const { return representation_; }
    const std::vector<Genome>& population() const { return population_; }
    /// Moves the population out of a search that is no longer needed.
    std::vector<Genome> take_population() && { return std::move(population_); }
    /// Returns the number of generations evaluated so far.
    std::uint64_t generation() const { return generation_; }
    /// Returns how often no individual had positive fitness. The whole population except the elite was then drawn anew.
    /// The thesis does not mention this case, in which all sectors of the roulette wheel are empty.
    std::uint64_t redraws() const { return redraws_; }

    /// A function that is called after the evaluation of each generation and before breeding. Its arguments are this
    /// search and the fitness. Immigrants are then already in the population. Without a listener, nothing is computed
    /// for it.
    using Listener = std::function<void(const Search&, std::span<const double> fitness)>;
    void listen(Listener listener) { listener_ = std::move(listener); }

    /// Ends the evaluated generation: keeps its best individual, then reproduces, crosses and mutates. Throws
    /// std::invalid_argument unless there is one finite fitness for each individual.
    void next_generation(std::span<const double> fitness);

    /// Returns the best individual of the last evaluated generation. The best of all generations would mean little,
    /// because the fitness changes with the window. Throws std::logic_error before the first next_generation().
    const Individual& best() const;

    /// Returns copies of the emigrants with their fitness, by default of the best individual. Draws from this search's
    /// random stream. Throws as next_generation(), and UserError if the population has fewer individuals than
    /// emigrants.
    std::vector<Individual> emigrants(std::span<const double> fitness, const Emigration& emigration = {});
    /// Replaces individuals, by default the worst, by immigrants: their strings in population(), and their fitness in
    /// `fitness`. Returns for each immigrant the index of the individual that it replaced. Draws from this search's
    /// random stream. Throws as next_generation(), also for a string of another length. Throws UserError if there are
    /// more immigrants than individuals outside the elite. REQUIRES: !acceptance.among_offspring().
    Places accept(std::span<const Individual> immigrants, std::span<double> fitness, const Acceptance& acceptance = {});
    /// Replaces individuals of the new population by immigrants, except the elite at its beginning. The immigrants are
    /// evaluated with the new population. Throws as accept(). REQUIRES: next_generation() was called just before.
    Places accept_among_offspring(std::span<const Individual> immigrants);

private:
    void remember_best(std::span<const double> fitness);
    void require_fitness(std::span<const double> fitness) const;
    void require_length(const Individual& immigrant) const;

    Representation representation_;
    std::size_t elite_;
    Reproduction reproduction_;
    Crossover crossover_;
    double crossover_probability_;
    Mutation mutation_;
    double mutation_probability_;
    RandomStream random_;
    std::vector<Genome> population_;
    std::vector<Genome> offspring_; ///< memory for the next population, reused
    std::optional<Individual> best_;
    std::uint64_t generation_ = 0;
    std::uint64_t redraws_ = 0;
    Listener listener_;
};

} // namespace placedpar
