#pragma once

#include "gaprocs/policies/crossover.hpp"
#include "gaprocs/policies/mutation.hpp"
#include "gaprocs/policies/reproduction.hpp"
#include "gaprocs/representation/genome.hpp"

#include <cstddef>
#include <vector>

namespace placedpar {

/// The part of the measured record that the search uses at a time (thesis 3.1.1 and 4.3).
struct WindowSettings {
    std::size_t length = 10; ///< number of samples over which a fitness is summed
    /// Number of samples needed before the first generation. A window with fewer samples than this starts when it is
    /// full. The thesis does not specify this; the value is ours.
    std::size_t first = 5;
    std::size_t trials = 5; ///< generations per new sample
    double bias = 400;      ///< B of eq. 3.9, in the unit of the squared error

    /// Throws UserError if a setting is zero, if the length exceeds exact_fitness_terms, or if the bias is not
    /// positive.
    void validate() const;
    /// Throws as validate(), and UserError if the window is longer than the record.
    void validate_for(std::size_t record_length) const;
};

/// The largest population, in individuals. The limit is ours: a mistyped number with too many digits must not fill the
/// memory.
inline constexpr int largest_population = 1'000'000;

/// The settings of a genetic algorithm. The defaults are those of the thesis (rates of 5.4, "identical" by 4.3).
struct SearchSettings {
    std::size_t population = 120;
    double crossover_probability = 0.8;
    double mutation_probability = 0.01;
    std::size_t elite = 0;     ///< number of best individuals copied unchanged into the next generation; not in the
                               ///< thesis
    Reproduction reproduction; ///< by roulette
    Crossover crossover;       ///< one-point
    Mutation mutation;         ///< mutation of bits
    /// The first individuals of the first population. The others are drawn at random.
    std::vector<Genome> initial = {};
    WindowSettings window;

    /// Throws UserError if the population is below 2 or above largest_population, or if the elite leaves no pair to be
    /// bred. Throws it also if there are more initial individuals than the population, or if a probability is outside 0
    /// ... 1. Throws also as WindowSettings::validate().
    void validate() const;
};

/// Throws UserError if the crossover or the mutation does not work on these strings. The message names operators that
/// do.
void require_fitting_operators(const Representation&, const SearchSettings&);

} // namespace placedpar
