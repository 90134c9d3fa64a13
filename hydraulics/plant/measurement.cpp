#include "hydraulics/plant/measurement.hpp"

#include "hydraulics/data/parameters.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <numbers>

namespace placedpar::hydraulics {

MeasurementNoise measurement_noise(const Parameters& parameters) {
    return {parameters["noise.pressure"], parameters["noise.angle"], parameters["noise.spool"],
            parameters["noise.area"]};
}

std::size_t steps_in(double period_s, double step_s) {
    double ratio = period_s / step_s;
    double whole = std::round(ratio);
    if (!(whole >= 1) || std::abs(ratio - whole) > 1e-6 * whole)
        throw UnfitScenario(
            fmt::format("the sampling period is {:.9g} steps of the motion, expected a whole number", ratio));
    return static_cast<std::size_t>(whole);
}

double reading(double value, double resolution) { return std::nearbyint(value / resolution) * resolution; }

double standard_normal(const UniformSource& uniform) {
    double radius = std::sqrt(-2 * std::log(1 - uniform())); // 1 - u is never 0
    return radius * std::cos(2 * std::numbers::pi * uniform());
}

} // namespace placedpar::hydraulics
