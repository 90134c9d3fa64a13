#pragma once

#include "experiments/kit/experiment.hpp"

#include <vector>

namespace placedpar {

/// Numbers of floating-point operations; a change of sign is none.
struct Operations {
    double additions, multiplications, divisions;

    double all() const { return additions + multiplications + divisions; }
    /// Returns the cycles on a T800 in single precision (6, 11 and 16, typically), with a load for each operation.
    double t800_cycles() const { return 4 * all() + 6 * additions + 11 * multiplications + 16 * divisions; }
};

/// Returns the operations by which a search finds the fitness of one individual over a window of chapter 5's plant.
Operations operations_of_fitness(double window);
/// Returns the operations by which recursive least squares takes a sample.
Operations operations_of_recursion(double unknowns);

/// Judges "much less computational intensive (30 - 50 times less) than the conventional GA" (3.1).
std::vector<Comparison> computation_comparisons(const ReplayContext&);

} // namespace placedpar
