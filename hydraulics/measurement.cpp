#include "hydraulics/measurement.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <stdexcept>

namespace placedpar {

namespace {

/// Steps of the motion in one period.
std::size_t stride_of(std::span<const BoomState> motion, double period_s) {
    if (motion.size() < 2)
        throw std::invalid_argument("a motion of fewer than two states cannot be sampled");
    double ratio = period_s / (motion[1].time_s - motion[0].time_s);
    double whole = std::round(ratio);
    if (!(whole >= 1) || std::abs(ratio - whole) > 1e-6 * whole)
        throw std::invalid_argument(
            fmt::format("the sampling period is {} steps of the motion, expected a whole number", ratio));
    return static_cast<std::size_t>(whole);
}

/// REQUIRES: resolution is a power of two, so that nothing but the rounding to it rounds.
double reading(double value, double resolution) { return std::nearbyint(value / resolution) * resolution; }

} // namespace

double standard_normal(const UniformSource& uniform) {
    double radius = std::sqrt(-2 * std::log(1 - uniform())); // 1 - u is never 0
    return radius * std::cos(2 * std::numbers::pi * uniform());
}

Record measure_boom(std::span<const BoomState> motion, double moment_arm_in, double period_s,
                    const MeasurementNoise& noise, const UniformSource& uniform) {
    std::size_t stride = stride_of(motion, period_s);
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
            record.of(MachineLink::boom, sensor).push_back(reading(value, resolution));
        };
        record.time_s.push_back(state.time_s);
        read(Sensor::inlet_pressure, state.inlet_psi + pressure_noise, pressure_resolution_psi);
        read(Sensor::angle, angle_deg + angle_noise, angle_resolution_deg);
        read(Sensor::spool, state.spool_in + spool_noise, spool_resolution_in);
    }
    return record;
}

} // namespace placedpar
