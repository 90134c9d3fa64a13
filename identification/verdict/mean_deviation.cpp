#include "identification/verdict/mean_deviation.hpp"

#include "identification/verdict/way_matrices.hpp"

namespace placedpar::identification {

Deviation mean_deviation(const std::vector<Deviation>& movements) {
    WayMatrix information = WayMatrix::Zero();
    WayVector pull = WayVector::Zero();
    for (const Deviation& each : movements) {
        const WayMatrix of_each = matrix_of(each.information());
        information += of_each;
        pull += of_each * vector_of(each.by);
    }
    const WayMatrix covariance = information.inverse();
    return {ways_of(covariance * pull), two_ways_of(covariance)};
}

} // namespace placedpar::identification
