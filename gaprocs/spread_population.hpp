#pragma once

#include "gaprocs/recoding.hpp"
#include "gaprocs/search_problem.hpp"
#include "runtime/random.hpp"

#include <cstddef>
#include <vector>

namespace placedpar {

/// A first population that covers the space better than a random one (thesis 6.3, "predefined populations"): of each
/// field the codes are evenly spread over its range, in an order drawn for each field by itself (Latin hypercube
/// sampling, M. McKay et al., 1979). "Don't care" bits are 0. Strings as they are bred. At least `count` numbers a
/// field.
/// REQUIRES: reading.validate() throws nothing.
std::vector<Genome> spread_population(std::size_t count, const Recoding& reading, RandomStream& random);
/// Of the problem's own strings, as it codes them. Throws UserError: they have no fields of bits.
std::vector<Genome> spread_population(std::size_t count, const SearchProblem& problem, RandomStream& random);

} // namespace placedpar
