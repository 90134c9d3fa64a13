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

/// The state of a search between two generations, besides its settings and its random stream.
struct SearchState {
    std::uint64_t generation = 0; ///< number of generations evaluated
    std::uint64_t redraws = 0;
    std::uint64_t drawn = 0; ///< how many numbers have been drawn from the random stream
    std::vector<Genome> population;
    std::optional<Individual> best; ///< best individual of the last evaluated generation; nothing before the first

    friend bool operator==(const SearchState&, const SearchState&) = default;
};

/// A genetic algorithm with one population, the core of every search. It breeds one generation at a time, but does not
/// evaluate individuals. The caller (a plain loop, a master with slaves, an island) computes the fitness of
/// population() and passes it to next_generation(). The next generation depends only on the settings, the random stream
/// and the fitness. So a search whose slaves compute the fitness (algorithm A of the thesis) makes exactly the same
/// generations as the traditional algorithm.
///
/// An island is a search that exchanges individuals with others. After an evaluation, it calls emigrants(), accept()
/// and next_generation(), in this order. If immigrants replace new offspring (Acceptance::among_offspring()), it calls
/// emigrants(), next_generation() and accept_among_offspring().
///
/// The elite, the best SearchSettings::elite individuals, is copied unchanged to the beginning of the next population,
/// the best individual first. Only the strings are copied: the elite is evaluated again like all others, because its
/// fitness changes when newer measurements arrive. With an elite, the best fitness never decreases as long as the
/// measurements stay the same.
class Search {
public:
    /// Takes the first individuals from SearchSettings::initial and draws the others. Throws what
    /// SearchSettings::validate() and require_fitting_operators() throw. Throws UserError if an initial individual does
    /// not have representation.bits() bits.
    Search(Representation representation, const SearchSettings& settings, RandomStream random);
    /// Makes a search of binary strings. Throws what the first constructor throws, and std::invalid_argument for 0
    /// bits.
    Search(std::size_t bits, const SearchSettings& settings, RandomStream random)
        : Search(BitString(bits), settings, std::move(random)) {}
    /// Starts from a given population of binary strings. Throws what the first constructor throws. Throws
    /// std::invalid_argument if the population does not have settings.population strings, or if they have different
    /// lengths.
    Search(std::vector<Genome> population, const SearchSettings& settings, RandomStream random);

    const Representation& representation() const { return representation_; }
    const std::vector<Genome>& population() const { return population_; }
    std::vector<Genome> take_population() && { return std::move(population_); }
    std::uint64_t generation() const { return generation_; }
    /// Returns the number of times that the population, except the elite, was drawn anew because the selection found no
    /// parents. Roulette selection finds none if no fitness is positive; the thesis does not mention this case.
    std::uint64_t redraws() const { return redraws_; }

    /// Returns the state, from which go_on_from() continues with the next evaluation.
    SearchState state() const { return {generation_, redraws_, random_.drawn(), population_, best_}; }
    /// Continues from the state of a search with the same representation, settings and random stream. Throws UserError
    /// if the state has another number of individuals, strings of another representation, or a best fitness that is not
    /// finite.
    void go_on_from(SearchState);
    /// Returns whether the string belongs to this search's representation and the fitness is finite.
    bool is_valid(const Individual&) const;

    /// A function that next_generation() calls before it breeds, to report the evaluated generation. At this time the
    /// population already includes the immigrants of accept().
    using Listener = std::function<void(const Search&, std::span<const double> fitness)>;
    void listen(Listener listener) { listener_ = std::move(listener); }

    /// Keeps the best individual of the evaluated generation, then breeds the next: reproduction, crossover and
    /// mutation. Throws std::invalid_argument unless there is one finite fitness for each individual.
    void next_generation(std::span<const double> fitness);

    /// Returns the best individual of the last evaluated generation. Individuals of earlier generations do not count,
    /// because the fitness changes when newer measurements arrive. Throws std::logic_error before the first
    /// next_generation().
    const Individual& best() const;

    /// Returns copies of the individuals that leave for other islands, with their fitness; by default, the best
    /// individual. Draws from this search's random stream. Throws what next_generation() and `emigration` throw.
    std::vector<Individual> emigrants(std::span<const double> fitness, const Emigration& emigration = {});
    /// Replaces individuals by immigrants, both in population() and in `fitness`; by default, an immigrant replaces the
    /// worst individual. Returns for each immigrant the index of the individual that it replaced. Draws from this
    /// search's random stream. Throws what next_generation() and `acceptance` throw, and std::invalid_argument for an
    /// immigrant of another length. REQUIRES: !acceptance.among_offspring().
    Places accept(std::span<const Individual> immigrants, std::span<double> fitness, const Acceptance& acceptance = {});
    /// Replaces individuals outside the elite by immigrants, in the population that next_generation() has bred. Throws
    /// what Acceptance::validate_for() throws, and std::invalid_argument for an immigrant of another length. REQUIRES:
    /// the population has not been evaluated since next_generation().
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
    std::vector<Genome> offspring_; ///< the next population while it is bred; a member to reuse the memory
    std::optional<Individual> best_;
    std::uint64_t generation_ = 0;
    std::uint64_t redraws_ = 0;
    Listener listener_;
};

} // namespace placedpar
