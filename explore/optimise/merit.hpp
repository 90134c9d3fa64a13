#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace placedpar {

/// The merit of a machine in a search.
struct Merit {
    bool feasible = false;
    std::vector<double> costs; ///< costs to be minimised; each feasible machine has the same number
};

/// Returns whether the first merit dominates the second. A feasible machine dominates an infeasible one (K. Deb, "An
/// efficient constraint handling method for genetic algorithms", 2000). A feasible machine dominates another if it is
/// not worse in any cost and better in at least one.
bool dominates(const Merit&, const Merit&);

/// Returns the indices of the feasible machines that no other dominates, in ascending order of the first cost, and of
/// the index for equal costs.
std::vector<std::size_t> front_of(std::span<const Merit>);

/// Returns all indices, the best first, in the order of NSGA-II (K. Deb, A. Pratap, S. Agarwal and T. Meyarivan, 2002):
/// first the machines that no other dominates, then those that only the first front dominates, and so on. Within a
/// front, the ends come first, then the machines farthest from their neighbours. With one cost, the machines are in
/// ascending order of cost. Of machines that rank equally, the lower index comes first.
std::vector<std::size_t> order_of(std::span<const Merit>);

} // namespace placedpar
