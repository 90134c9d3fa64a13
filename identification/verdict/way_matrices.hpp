#pragma once

#include "identification/verdict/fault_hypothesis.hpp"

#include <Eigen/Dense>

namespace placedpar::identification {

/// These Eigen types are for computing with PerHypothesis and PerPairOfHypotheses, the values and the matrix of a
/// link's possible faults. The types are not aligned, so that copying them compiles to the same code with all compiler
/// flags.
using WayVector = Eigen::Matrix<double, all_hypotheses.size(), 1, Eigen::DontAlign>;
using WayMatrix = Eigen::Matrix<double, all_hypotheses.size(), all_hypotheses.size(), Eigen::DontAlign>;

inline constexpr Eigen::Index row_of(FaultHypothesis way) { return static_cast<Eigen::Index>(way); }

inline WayVector vector_of(const PerHypothesis& ways) { return WayVector(ways.data()); }
inline WayMatrix matrix_of(const PerPairOfHypotheses& two_ways) { return WayMatrix(two_ways.data()); }

inline PerHypothesis ways_of(const WayVector& vector) {
    PerHypothesis ways;
    Eigen::Map<WayVector>(ways.data()) = vector;
    return ways;
}
inline PerPairOfHypotheses two_ways_of(const WayMatrix& matrix) {
    PerPairOfHypotheses two_ways;
    Eigen::Map<WayMatrix>(two_ways.data()) = matrix;
    return two_ways;
}

} // namespace placedpar::identification
