#pragma once

#include "gaprocs/policies/crossover.hpp"
#include "gaprocs/policies/mutation.hpp"
#include "gaprocs/policies/reproduction.hpp"
#include "gaprocs/representation/genome.hpp"

#include <cstddef>
#include <vector>

namespace placedpar {

/// How the measured record is presented to the search (thesis 3.1.1 and 4.3).
struct WindowSettings {
    std::size_t length = 10; ///< samples a fitness is summed over
    /// Samples needed before the first generation; ours, the thesis is silent. A window shorter than this starts when
    /// it is full.
    std::size_t first = 5;
    std::size_t trials = 5; ///< generations per new sample
    double bias = 400;      ///< B of eq. 3.9, in the unit of the problem's error squared

    /// Throws UserError: a zero, a length beyond exact_fitness_terms, a bias that is not positive.
    void validate() const;
    /// Throws as validate(), and when the window is longer than the record.
    void validate_for(std::size_t record_length) const;
};

/// Our limit: a number mistyped with too many digits must not fill the memory.
inline constexpr int largest_population = 1'000'000;

/// A genetic algorithm's numbers; the defaults are the thesis's (rates of 5.4, "identical" by 4.3).
struct SearchSettings {
    std::size_t population = 120;
    double crossover_probability = 0.8;
    double mutation_probability = 0.01;
    std::size_t elite = 0;     ///< best individuals copied unchanged into the next generation; the thesis mentions none
    Reproduction reproduction; ///< by roulette
    Crossover crossover;       ///< one-point
    Mutation mutation;         ///< mutation of bits
    /// The first individuals of the first population; the others are drawn at random.
    std::vector<Genome> initial = {};
    WindowSettings window;

    /// Throws UserError: population < 2 or > largest_population, an elite that leaves no pair to be bred, more initial
    /// individuals than the population has, a probability outside 0 ... 1, or as the window's.
    void validate() const;
};

/// Throws UserError for a crossover or a mutation that does not work on these strings; the message names those that do.
void require_fitting_operators(const Representation&, const SearchSettings&);

} // namespace placedpar
