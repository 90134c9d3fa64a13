#pragma once

#include "gaprocs/policies/crossover.hpp"
#include "gaprocs/policies/mutation.hpp"
#include "gaprocs/policies/reproduction.hpp"
#include "gaprocs/representation/genome.hpp"

#include <cstddef>
#include <vector>

namespace placedpar {

/// The settings of the window, that is, of the newest samples of measurements, over which fitness is computed (thesis
/// 3.1.1 and 4.3).
struct WindowSettings {
    std::size_t length = 10; ///< number of samples in a full window
    /// Number of samples before the first generation; if `length` is less, `length` samples. The thesis does not
    /// specify this number; 5 is PlacedPar's choice.
    std::size_t first = 5;
    std::size_t trials = 5; ///< number of generations after each new sample
    double bias = 400;      ///< B of eq. 3.9, fitness = sum of B - error^2; in the unit of the squared error

    /// Throws UserError unless every setting is above 0, `length` <= `exact_fitness_terms` and `bias` <=
    /// `fitness_term_limit`.
    void validate() const;
    /// Throws what validate() throws, and UserError if the window is longer than the record.
    void validate_for(std::size_t record_length) const;
};

/// The largest population, in individuals. Without a limit, a number typed with too many digits would exhaust the
/// memory.
inline constexpr int largest_population = 1'000'000;

/// The settings of a genetic algorithm. The defaults are the settings of the thesis (for the probabilities see 5.4).
struct SearchSettings {
    std::size_t population = 120;
    double crossover_probability = 0.8;
    double mutation_probability = 0.01;
    std::size_t elite = 0;     ///< number of best individuals that are copied unchanged into the next generation; not
                               ///< in the thesis
    Reproduction reproduction; ///< default: roulette
    Crossover crossover;       ///< default: one-point
    Mutation mutation;         ///< default: bit
    /// The first individuals of the first population; the others are drawn at random.
    std::vector<Genome> initial = {};
    WindowSettings window;

    /// Throws UserError if `population` is below 2 or above `largest_population`, if there are more than `population`
    /// initial individuals, or if fewer than two individuals are outside the elite. Throws it also if a probability is
    /// outside 0 ... 1 or if a number of a policy (reproduction, crossover or mutation) is out of range. Throws what
    /// WindowSettings::validate() throws.
    void validate() const;
};

/// Throws UserError if the crossover or the mutation does not work on this kind of strings. The message names the
/// operators that work on them.
void require_fitting_operators(const Representation&, const SearchSettings&);

} // namespace placedpar
