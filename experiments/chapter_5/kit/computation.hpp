#pragma once

#include "experiments/kit/experiment.hpp"

#include <vector>

namespace placedpar {

/// Numbers of floating-point operations, by which methods are compared. A change of sign does not count.
struct Operations {
    double additions, multiplications, divisions;

    double all() const { return additions + multiplications + divisions; }
    /// Returns the cycles on a T800 in single precision. An addition, multiplication or division typically takes 6, 11
    /// or 16 cycles, plus 4 cycles to load its operand.
    double t800_cycles() const { return 4 * all() + 6 * additions + 11 * multiplications + 16 * divisions; }
};

/// Returns the operations for the fitness of one individual of chapter 5's plant, over a window of this many samples.
Operations operations_of_fitness(double window);
/// Returns the operations of recursive least squares for one sample.
Operations operations_of_recursion(double unknowns);

/// Judges "much less computational intensive (30 - 50 times less) than the conventional GA" (3.1).
std::vector<Comparison> computation_comparisons(const ReplayContext&);

} // namespace placedpar
