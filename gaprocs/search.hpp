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
/// depends on the settings, the stream and those numbers alone, not on which process found them: so algorithm A gives
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
    /// Draws the first population, but for SearchSettings::initial. Throws as SearchSettings::validate(), and UserError
    /// for a crossover or a mutation that does not fit the representation and for initial individuals of another
    /// length.
    Search(Representation representation, const SearchSettings& settings, RandomStream random);
    /// The same of binary strings. Throws also std::invalid_argument for 0 bits.
    Search(std::size_t bits, const SearchSettings& settings, RandomStream random)
        : Search(BitString(bits), settings, std::move(random)) {}
    /// Goes on from a given population of binary strings. Throws std::invalid_argument also when it is not
    /// settings.population strings of one length.
    Search(std::vector<Genome> population, const SearchSettings& settings, RandomStream random);

    const Representation& representation() const { return representation_; }
    const std::vector<Genome>& population() const { return population_; }
    /// The population of a search that is not needed any more.
    std::vector<Genome> take_population() && { return std::move(population_); }
    /// Generations evaluated so far.
    std::uint64_t generation() const { return generation_; }
    /// How often no individual had positive fitness, so that the whole population but the elite was drawn anew. The
    /// thesis is silent on this case, in which no sector of the roulette wheel has any width.
    std::uint64_t redraws() const { return redraws_; }

    /// Who is told of each evaluated generation as it is about to breed, its immigrants among the population: this
    /// search and the fitness. Nothing is computed without a listener.
    using Listener = std::function<void(const Search&, std::span<const double> fitness)>;
    void listen(Listener listener) { listener_ = std::move(listener); }

    /// Ends the evaluated generation: remembers its best, then reproduction, crossover and mutation.
    /// Throws std::invalid_argument unless there is one finite fitness for each individual.
    void next_generation(std::span<const double> fitness);

    /// The best of the last evaluated generation, not of all time: the window, and with it fitness, moves.
    /// Throws std::logic_error before the first next_generation().
    const Individual& best() const;

    /// Copies of those who leave for another island, with this fitness: by default the best. Ways that draw take their
    /// numbers from this search's stream. Throws as next_generation(), and UserError when more leave than there are.
    std::vector<Individual> emigrants(std::span<const double> fitness, const Emigration& emigration = {});
    /// Each immigrant that is not turned away replaces an individual, by default the worst, better or not: its string
    /// in population(), its fitness in `fitness`. Says where each came to live. Draws as emigrants(). Throws as
    /// next_generation(), when a string has another length, and UserError for more immigrants than there are
    /// individuals that are not of the elite. REQUIRES: !acceptance.among_offspring().
    Places accept(std::span<const Individual> immigrants, std::span<double> fitness, const Acceptance& acceptance = {});
    /// After next_generation(): each immigrant overwrites an individual of the new population, the elite at its head
    /// excepted, and is evaluated with it. Throws as accept().
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
    std::vector<Genome> offspring_; ///< the next population in the making: kept to reuse its memory
    std::optional<Individual> best_;
    std::uint64_t generation_ = 0;
    std::uint64_t redraws_ = 0;
    Listener listener_;
};

} // namespace placedpar
