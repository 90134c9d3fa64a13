#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace placedpar {

/// What a machine is worth to a search.
struct Merit {
    bool feasible = false;
    std::vector<double> costs; ///< to be minimised; of one number for all feasible machines
};

/// Returns whether the first dominates the second: feasible before infeasible (K. Deb, "An efficient constraint
/// handling method for genetic algorithms", 2000); of two feasible ones, not worse in any cost and better in one.
bool dominates(const Merit&, const Merit&);

/// Of different machines, those that no other dominates, the least of the first cost first; of equals the lower index
/// first. None is infeasible.
std::vector<std::size_t> front_of(std::span<const Merit>);

/// All, the best first, as NSGA-II orders them (K. Deb, A. Pratap, S. Agarwal and T. Meyarivan, 2002): those that none
/// dominates, then those whom only these dominate, and so on; within such a front those that stand most apart from
/// their neighbours in it, the ends of the front first. With one cost: by the cost. Of equals the lower index first.
std::vector<std::size_t> order_of(std::span<const Merit>);

} // namespace placedpar
