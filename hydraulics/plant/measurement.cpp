#include "hydraulics/plant/measurement.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <stdexcept>

namespace placedpar::hydraulics {

std::size_t steps_in(double period_s, double step_s) {
    double ratio = period_s / step_s;
    double whole = std::round(ratio);
    if (!(whole >= 1) || std::abs(ratio - whole) > 1e-6 * whole)
        throw std::invalid_argument(
            fmt::format("the sampling period is {:.9g} steps of the motion, expected a whole number", ratio));
    return static_cast<std::size_t>(whole);
}

double reading(double value, double resolution) { return std::nearbyint(value / resolution) * resolution; }

double standard_normal(const UniformSource& uniform) {
    double radius = std::sqrt(-2 * std::log(1 - uniform())); // 1 - u is never 0
    return radius * std::cos(2 * std::numbers::pi * uniform());
}

Record measure_boom(std::span<const BoomState> motion, double moment_arm_in, double period_s,
                    const MeasurementNoise& noise, const UniformSource& uniform) {
    std::size_t stride = steps_in(period_s, step_of(motion));
    constexpr double deg_per_rad = 180 / std::numbers::pi;
    Record record;
    record.period_s = period_s;
    for (std::size_t i = 0; i < motion.size(); i += stride) {
        const BoomState& state = motion[i];
        double pressure_noise = noise.pressure_psi * standard_normal(uniform);
        double angle_noise = noise.angle_deg * standard_normal(uniform);
        double spool_noise = noise.spool_in * standard_normal(uniform);
        double angle_deg = state.piston_in / moment_arm_in * deg_per_rad;
        auto read = [&](Sensor sensor, double value, double resolution) {
            record.of(Link::boom, sensor).push_back(reading(value, resolution));
        };
        record.time_s.push_back(state.time_s);
        read(Sensor::inlet_pressure, state.inlet_psi + pressure_noise, pressure_resolution_psi);
        read(Sensor::angle, angle_deg + angle_noise, angle_resolution_deg);
        read(Sensor::spool, state.spool_in + spool_noise, spool_resolution_in);
    }
    return record;
}

} // namespace placedpar::hydraulics
