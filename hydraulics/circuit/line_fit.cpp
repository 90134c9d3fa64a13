#include "hydraulics/circuit/line_fit.hpp"

#include <Eigen/QR>

#include <cassert>
#include <stdexcept>

namespace placedpar::hydraulics {

namespace {

// The matrices have a fixed size. With a dynamic size, the order of the terms in a sum, and so the rounding, could
// depend on the alignment of memory.
using Points = Eigen::Matrix<double, line_fit_points, 1>;

} // namespace

CentredLineFit::CentredLineFit(double period_s) {
    if (!(period_s > 0))
        throw std::invalid_argument("a line fit needs a sampling period above 0");
    // values = mean + slope * time: the pseudo-inverse's second row maps values to the slope.
    Eigen::Matrix<double, line_fit_points, 2> design;
    for (int i = 0; i < design.rows(); ++i)
        design.row(i) << 1, (i - 2) * period_s;
    Eigen::Matrix<double, line_fit_points, line_fit_points> unit;
    unit.setIdentity();
    Eigen::Matrix<double, 2, line_fit_points> inverse = design.householderQr().solve(unit);
    Eigen::Map<Points>(slope_weights_.data()) = inverse.row(1).transpose();
}

double CentredLineFit::slope_per_s(std::span<const double> values, std::size_t centre) const {
    assert(has_slope(values.size(), centre));
    const Points weights(slope_weights_.data());
    return weights.dot(Eigen::Map<const Points>(values.data() + centre - line_fit_points / 2));
}

} // namespace placedpar::hydraulics
