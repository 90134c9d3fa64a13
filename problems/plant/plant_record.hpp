#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace placedpar {

class RandomStream;

/// The second-order plant of thesis eq. 5.8 with the delay d of eq. 5.9. It has the output y, the input u and the noise
/// e:
///
///     y(k) = a1 y(k-1) + a2 y(k-2) + b0 (u(k-d) + b1 u(k-d-1)) + e(k) + c1 e(k-1) + c2 e(k-2)
///
/// Equation 5.8 has u(k), that is, d = 0. But the search of Table 5.1 looks only for d >= 1, so d is 1 here.
struct Plant {
    double a1 = 1.5, a2 = -0.7, b0 = 1, b1 = 0.5;
    std::size_t delay = 1; ///< in samples, 1 to 4
};

/// pole_of() returns the pole alpha + j beta, beta >= 0, of y(k) = a1 y(k-1) + a2 y(k-2). REQUIRES: the poles are a
/// complex pair.
struct Pole {
    double alpha, beta;
};
Pole pole_of(double a1, double a2);

/// The change of a1 during an experiment, which a search has to follow. a1 changes linearly with the generation, from
/// 1.5 to `a1`. Table 5.4 prints a1 = -1.5 + 1.0 (gen - 200). The printed sign is the sign of the coefficient in
/// A(q^-1). With the printed slope, the plant would be unstable from the second generation of the change on. The
/// default keeps the times of the table: between generations 200 and 400, a1 falls from 1.5 by (gen - 200) / 200.
struct PlantChange {
    double a1 = 0.5;    ///< value at the end
    double from = 200;  ///< generation at which the change begins
    double lasts = 200; ///< duration in generations; 0: a step

    static const PlantChange none, ramp, step;
};
inline constexpr PlantChange PlantChange::none{.a1 = 1.5}, PlantChange::ramp{}, PlantChange::step{.lasts = 0};

double a1_at(const PlantChange& change, double generation);

/// An experiment on the plant, as chapter 5 describes it. The input is 1 or -1, and may change every four samples; a
/// pseudo-random bit decides.
struct PlantExperiment {
    PlantChange change = PlantChange::ramp;
    double noise = 0;               ///< standard deviation of the Gaussian noise e
    std::array<double, 2> colour{}; ///< c1 and c2; both 0: white noise
    std::size_t generations = 601;  ///< number of generations; Table 5.4 has 0 to 600
    std::size_t per_sample = 3; ///< generations of the search between two samples; chapter 5 does not state this number
    std::size_t window = 30;    ///< number of samples available at generation 0
    std::size_t settling = 80;  ///< number of samples that are simulated before the record begins

    /// Returns the number of samples that arrive from generation 0 on. REQUIRES: per_sample > 0.
    std::size_t samples() const { return (generations + per_sample - 1) / per_sample; }
    std::size_t record_length() const { return window - 1 + samples(); }
};

/// A sample of the plant's record consists of the outputs y(k), y(k-1), y(k-2) and the inputs u(k-1), ..., u(k-6).
inline constexpr std::size_t plant_inputs = 6;
inline constexpr std::size_t plant_channels = 3 + plant_inputs;

/// Returns the record: `window` - 1 samples before generation 0, one at generation 0, then one every `per_sample`
/// generations. Draws one random number for the place in the input's period at which the input begins, and, if `noise`
/// is above 0, two for each simulated sample. Throws UserError if `window` or `per_sample` is 0, or if `noise` is
/// negative or not finite.
std::vector<std::vector<double>> plant_record(const PlantExperiment& experiment, RandomStream random);

} // namespace placedpar
