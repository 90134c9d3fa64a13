#pragma once

#include "hydraulics/plant/requirement.hpp"

#include <cstddef>
#include <functional>
#include <span>

namespace placedpar::hydraulics {

class Parameters; // hydraulics/data/parameters.hpp

/// The standard deviations of the white Gaussian noise on each sensor.
struct MeasurementNoise {
    double pressure_psi = 0;
    double angle_deg = 0;
    double spool_in = 0;
    double area_share = 0; ///< noise of measured orifice areas, as a share of the area
};

/// Reads the parameters noise.*.
MeasurementNoise measurement_noise(const Parameters& parameters);

/// The noise levels of the identification studies, chosen for this project.
inline constexpr MeasurementNoise no_noise{};
inline constexpr MeasurementNoise low_noise{2, 0.003, 0.0003, 0.001};
inline constexpr MeasurementNoise mid_noise{5, 0.005, 0.0005, 0.002};
inline constexpr MeasurementNoise high_noise{10, 0.01, 0.001, 0.004};

/// A source of random numbers uniform in [0, 1). The caller provides it, so that the caller's seed determines the
/// record.
using UniformSource = std::function<double()>;

/// Returns one number from the standard normal distribution, computed from two uniform numbers by the cosine formula of
/// Box and Muller.
double standard_normal(const UniformSource& uniform);

/// The thesis samples every 20 ms.
inline constexpr double sampling_period_s = 0.020;

/// The resolutions to which readings are rounded, far below any noise. The last bits of exp, log and tanh may differ
/// between mathematical libraries. Rounding keeps these bits out of the record, so that all machines compute the same
/// record.
inline constexpr double pressure_resolution_psi = 0x1p-20;
inline constexpr double angle_resolution_deg = 0x1p-30;
inline constexpr double spool_resolution_in = 0x1p-30;
inline constexpr double area_resolution_in2 = 0x1p-30;

/// Rounds a value to the resolution. REQUIRES: the resolution is a power of two, so that division and multiplication by
/// it are exact.
double reading(double value, double resolution);

/// Returns the step of a motion whose states are equally spaced. Throws UnfitScenario for fewer than two states.
template <class State>
double step_of(std::span<const State> motion) {
    if (motion.size() < 2)
        throw UnfitScenario("a motion of fewer than two states cannot be sampled");
    return motion[1].time_s - motion[0].time_s;
}

/// Returns the number of integration steps in a sampling period. Throws UnfitScenario if this number is not whole.
std::size_t steps_in(double period_s, double step_s);

} // namespace placedpar::hydraulics
