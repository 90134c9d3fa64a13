#pragma once

#include "gaprocs/objective.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace placedpar {

/// Returns whether an individual with the first merit dominates an individual with the second. A feasible individual
/// satisfies all constraints. It dominates every infeasible individual. An infeasible individual dominates another
/// infeasible individual if its total violation of constraints is less (K. Deb, "An efficient constraint handling
/// method for genetic algorithms", 2000). A feasible individual dominates another feasible individual if it is not
/// worse in any cost and better in at least one cost.
bool dominates(const Merit&, const Merit&);

/// Returns the indices of the feasible individuals that no other individual dominates, in ascending order of the first
/// cost, then of the index.
std::vector<std::size_t> front_of(std::span<const Merit>);

/// Returns all indices, the best first, in the order of NSGA-II (K. Deb, A. Pratap, S. Agarwal and T. Meyarivan, 2002):
/// first the front, that is, the individuals that no other individual dominates; then the front of the remaining
/// individuals, and so on. Within a front, the individuals with the least and greatest value of a cost come first, then
/// the individuals farthest from their neighbours. With one cost, feasible individuals are ordered by this cost. Among
/// equals, the lower index comes first. The costs of infeasible individuals do not matter and may be missing.
std::vector<std::size_t> order_of(std::span<const Merit>);

} // namespace placedpar
