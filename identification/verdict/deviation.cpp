#include "identification/verdict/deviation.hpp"

#include "identification/verdict/way_matrices.hpp"

#include <cmath>

namespace placedpar::identification {

bool has_inverse(const PerPairOfHypotheses& two_ways) {
    const WayMatrix matrix = matrix_of(two_ways);
    return matrix.allFinite() && matrix.llt().info() == Eigen::Success;
}

double Deviation::standard_error(FaultHypothesis way) const {
    return std::sqrt(matrix_of(covariance)(row_of(way), row_of(way)));
}

PerPairOfHypotheses Deviation::information() const {
    WayMatrix with_scatter = matrix_of(covariance);
    with_scatter.diagonal().array() += repeats_within * repeats_within;
    with_scatter(row_of(FaultHypothesis::offset), row_of(FaultHypothesis::offset)) +=
        offset_repeats_within * offset_repeats_within - repeats_within * repeats_within;
    return two_ways_of(with_scatter.inverse());
}

Deviation Deviation::with_steady_leak() const {
    WayVector difference = WayVector::Zero();
    difference[row_of(FaultHypothesis::leak)] = 1;
    difference[row_of(FaultHypothesis::leak_before)] = -1;
    const WayVector found = vector_of(by);
    const WayMatrix known = matrix_of(covariance);
    const WayVector shared = known * difference;
    const double variance = difference.dot(shared);
    if (variance <= 0)
        return *this;
    return {ways_of(found - shared * difference.dot(found) / variance),
            two_ways_of(known - shared * shared.transpose() / variance)};
}

} // namespace placedpar::identification
