#pragma once

#include "gaprocs/representation/genome.hpp"
#include "gaprocs/representation/schema.hpp"

#include <span>

namespace placedpar {

/// Returns a lower bound for the expected number of strings of the next generation that match the schema, by the schema
/// theorem (thesis eq. 6.2):
///
///     m(h, t + 1) >= m(h, t) F(h, t) / F(t) (1 - p_c delta(h) / (l - 1)) (1 - p_m)^O(h)
///
/// where m is the number of matching strings, F(h, t) their mean fitness, F(t) the mean fitness of all strings and l
/// the length of a string. delta(h) is the distance between the first and the last fixed position of the schema h, and
/// O(h) the number of its fixed positions. p_c and p_m are the probabilities of crossover and mutation. The bound is
/// low because it does not count matching strings that crossover and mutation create. It holds for reproduction in
/// proportion to fitness (roulette, stochastic universal sampling), one-point crossover and bit mutation. Negative
/// fitness counts as 0, as on the roulette wheel. Returns 0 if no fitness is positive. REQUIRES: fitness.size() ==
/// population.size(); all strings have schema.size() bits.
double schema_bound(const Schema& schema, std::span<const Genome> population, std::span<const double> fitness,
                    double crossover_probability, double mutation_probability);

} // namespace placedpar
