#pragma once

#include "gaprocs/objective.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace placedpar {

/// Returns whether the first merit dominates the second. A feasible individual dominates every infeasible individual.
/// The lesser violation decides between two infeasible individuals (K. Deb, "An efficient constraint handling method
/// for genetic algorithms", 2000). A feasible individual dominates another feasible individual if it is not worse in
/// any cost and better in at least one cost.
bool dominates(const Merit&, const Merit&);

/// Returns the indices of the feasible individuals that no other dominates, in ascending order of the first cost,
/// then of the index.
std::vector<std::size_t> front_of(std::span<const Merit>);

/// Returns all indices, the best first, in the order of NSGA-II (K. Deb, A. Pratap, S. Agarwal and T. Meyarivan, 2002):
/// first the front, then the front of the remaining individuals, and so on. Within a front, the two ends come first,
/// then the individuals farthest from their neighbours. With one cost, individuals are ordered by this cost. If
/// individuals rank equally, the lower index comes first; infeasible individuals may have any costs, or none.
std::vector<std::size_t> order_of(std::span<const Merit>);

} // namespace placedpar
