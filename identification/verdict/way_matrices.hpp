#pragma once

#include "identification/verdict/ways.hpp"

#include <Eigen/Dense>

namespace placedpar::identification {

/// OfWays and OfTwoWays as Eigen computes with them, for sources alone. Not aligned, so that copies of them are the
/// same code whatever the flags of the compiler are.
using WayVector = Eigen::Matrix<double, all_ways.size(), 1, Eigen::DontAlign>;
using WayMatrix = Eigen::Matrix<double, all_ways.size(), all_ways.size(), Eigen::DontAlign>;

inline constexpr Eigen::Index row_of(Way way) { return static_cast<Eigen::Index>(way); }

inline WayVector vector_of(const OfWays& ways) { return WayVector(ways.data()); }
inline WayMatrix matrix_of(const OfTwoWays& two_ways) { return WayMatrix(two_ways.data()); }

inline OfWays ways_of(const WayVector& vector) {
    OfWays ways;
    Eigen::Map<WayVector>(ways.data()) = vector;
    return ways;
}
inline OfTwoWays two_ways_of(const WayMatrix& matrix) {
    OfTwoWays two_ways;
    Eigen::Map<WayMatrix>(two_ways.data()) = matrix;
    return two_ways;
}

} // namespace placedpar::identification
