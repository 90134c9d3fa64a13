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

/// The state of a traditional genetic algorithm, one generation at a time. It does not evaluate: its owner (a plain
/// loop, a master with its slaves, an island) finds the fitness of population() and hands it in. The next generation
/// depends only on the settings, the stream and the fitness, not on which process computed it: so algorithm A gives
/// exactly the generations of the traditional algorithm.
///
/// The order of calls on an island: evaluate; emigrants() to the neighbours; accept() the immigrants;
/// next_generation(). Where immigrants come among the offspring, accept_among_offspring() follows instead.
///
/// An elite (SearchSettings::elite) is copied unchanged to the head of the next population, the best first. Only the
/// strings are copied: the elite is evaluated again with all others, since its fitness changes when the window moves.
/// While the window stays, the best fitness never falls.
class Search {
public:
    /// Takes the first individuals from SearchSettings::initial and draws the others. Throws as
    /// SearchSettings::validate(), and UserError for a crossover or a mutation that does not fit the representation and
    /// for initial individuals of another length.
    Search(Representation representation, const SearchSettings& settings, RandomStream random);
    /// As above, with binary strings. Throws also std::invalid_argument for 0 bits.
    Search(std::size_t bits, const SearchSettings& settings, RandomStream random)
        : Search(BitString(bits), settings, std::move(random)) {}
    /// Starts from a given population of binary strings. Throws std::invalid_argument also when it is not
    /// settings.population strings of one length.
    Search(std::vector<Genome> population, const SearchSettings& settings, RandomStream random);

    const Representation& representation() const { return representation_; }
    const std::vector<Genome>& population() const { return population_; }
    /// Moves the population out of a search that is no longer needed.
    std::vector<Genome> take_population() && { return std::move(population_); }
    /// Returns the number of generations evaluated so far.
    std::uint64_t generation() const { return generation_; }
    /// Returns how often no individual had positive fitness, so that the whole population except the elite was drawn
    /// anew. The thesis does not mention this case, in which all sectors of the roulette wheel are empty.
    std::uint64_t redraws() const { return redraws_; }

    /// A function called with this search and the fitness for each evaluated generation before it breeds, with
    /// immigrants already in the population. Without a listener, nothing is computed for it.
    using Listener = std::function<void(const Search&, std::span<const double> fitness)>;
    void listen(Listener listener) { listener_ = std::move(listener); }

    /// Ends the evaluated generation: remembers its best, then reproduction, crossover and mutation.
    /// Throws std::invalid_argument unless there is one finite fitness for each individual.
    void next_generation(std::span<const double> fitness);

    /// Returns the best of the last evaluated generation, not of all generations, since the fitness changes with the
    /// window. Throws std::logic_error before the first next_generation().
    const Individual& best() const;

    /// Returns copies of the individuals that leave for another island, with their fitness: by default the best. Random
    /// numbers are drawn from this search's stream. Throws as next_generation(), and UserError if more are to leave
    /// than the population has.
    std::vector<Individual> emigrants(std::span<const double> fitness, const Emigration& emigration = {});
    /// Replaces an individual, by default the worst, by each immigrant that is not turned away: its string in
    /// population() and its fitness in `fitness`. Returns the index of each immigrant. Draws as emigrants(). Throws as
    /// next_generation(), when a string has another length, and UserError for more immigrants than there are
    /// individuals that are not of the elite. REQUIRES: !acceptance.among_offspring().
    Places accept(std::span<const Individual> immigrants, std::span<double> fitness, const Acceptance& acceptance = {});
    /// Replaces an individual of the new population, except the elite at its head, by each immigrant, which is
    /// evaluated with the new population. Call it after next_generation(). Throws as accept().
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
    std::vector<Genome> offspring_; ///< next population; kept to reuse its memory
    std::optional<Individual> best_;
    std::uint64_t generation_ = 0;
    std::uint64_t redraws_ = 0;
    Listener listener_;
};

} // namespace placedpar
