#pragma once

#include "gaprocs/recoding.hpp"
#include "gaprocs/search_problem.hpp"
#include "runtime/random.hpp"

#include <cstddef>
#include <vector>

namespace placedpar {

/// Returns a first population that covers the search space better than a random one (thesis 6.3, "predefined
/// populations"). The codes of each field (the bits of one parameter) are evenly spread over the field's range, in an
/// order that is drawn separately for each field (Latin hypercube sampling, M. McKay et al., 1979). Unused (don't-care)
/// bits are 0. `reading` states the fields and the coding of the strings. Draws at least `count` numbers for each
/// field. REQUIRES: reading.validate() throws nothing.
std::vector<Genome> spread_population(std::size_t count, const Recoding& reading, RandomStream& random);
/// Returns such a population for a problem. Throws UserError if the problem's strings have no fields of bits.
std::vector<Genome> spread_population(std::size_t count, const SearchProblem& problem, RandomStream& random);

} // namespace placedpar
