#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace placedpar {

struct Merit {
    bool feasible = false;
    std::vector<double> costs; ///< costs to be minimised; all feasible machines have the same number of costs
};

/// Returns whether the first merit dominates the second. A feasible machine dominates every infeasible machine (K. Deb,
/// "An efficient constraint handling method for genetic algorithms", 2000). Of two feasible machines, one dominates the
/// other if it is not worse in any cost and better in at least one cost.
bool dominates(const Merit&, const Merit&);

/// Returns the indices of the feasible machines that no other machine dominates, in ascending order of the first cost,
/// then of the index.
std::vector<std::size_t> front_of(std::span<const Merit>);

/// Returns all indices, the best first, in the order of NSGA-II (K. Deb, A. Pratap, S. Agarwal and T. Meyarivan, 2002):
/// first the front, then the front of the remaining machines, and so on. Within a front, the two ends come first, then
/// the machines farthest from their neighbours. With one cost, the machines are in ascending order of cost. If machines
/// rank equally, the lower index comes first.
std::vector<std::size_t> order_of(std::span<const Merit>);

} // namespace placedpar
