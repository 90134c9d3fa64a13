#pragma once

#include "gaprocs/representation/parameter_coding.hpp"
#include "problems/plant/plant_record.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace placedpar {

/// A linear plant of second order, given by its poles alpha +- j beta, zeros gamma +- j delta, gain b0 and delay d in
/// samples (thesis eq. 5.9). T is double for one plant, Lanes (vectors of doubles) for several plants.
///
/// The plant of eq. 5.8 has the real zeros 0 and -.5. So that a search can find real zeros, a negative delta stands for
/// the real zeros gamma +- |delta|. The zeros of eq. 5.8 have gamma = delta = -.25.
template <typename T>
struct PoleZeroPlantOf {
    T d, alpha, beta, gamma, delta, b0;

    using Weights = std::array<T, plant_channels - 1>;

    /// Returns the weights of the outputs y(k-1), y(k-2) and the inputs u(k-1), ..., u(k-6) in the predicted output
    /// y-hat(k). REQUIRES: 1 <= d < 5; if T is Lanes, d is whole.
    Weights weights() const {
        using std::abs;
        Weights weights;
        weights[0] = 2 * alpha;
        weights[1] = -(alpha * alpha + beta * beta);
        std::fill(weights.begin() + 2, weights.end(), 0.0);
        behind_the_delay({b0, -2 * gamma * b0, (gamma * gamma + delta * abs(delta)) * b0}, weights);
        return weights;
    }

private:
    using Numerator = std::array<T, 3>;

    void behind_the_delay(const Numerator& numerator, Weights& weights) const requires std::constructible_from<int, T> {
        std::copy(numerator.begin(), numerator.end(), weights.begin() + 1 + static_cast<int>(d));
    }
    /// Sets the weights of several plants, which may have different delays. Adds the numerator at each possible delay,
    /// multiplied by 1 in the lanes of the plants with this delay and by 0 in the other lanes.
    void behind_the_delay(const Numerator& numerator, Weights& weights) const {
        for (std::size_t delay = 1; delay + 3 < weights.size(); ++delay) {
            T here = max(T(0.0), 1 - abs(d - static_cast<double>(delay)));
            for (std::size_t i = 0; i < numerator.size(); ++i)
                weights[1 + delay + i] += here * numerator[i];
        }
    }
};
using PoleZeroPlant = PoleZeroPlantOf<double>;

/// Returns d, alpha, beta, gamma, delta and b0 of a plant. Its zeros are 0 and -b1. REQUIRES: the plant has complex
/// poles.
std::vector<double> parameters_of(const Plant& plant);

/// The search for the parameters of a PoleZeroPlant from measured inputs and outputs. The string d | alpha | beta |
/// gamma | delta | b0 has 37 bits (Table 5.1). The error is y(k) - y-hat(k), where y-hat(k) is predicted from the two
/// outputs measured before y(k). Samples come from plant_record().
class PlantProblem {
public:
    PlantProblem();

    std::size_t bits() const { return coding_.bits(); }
    std::size_t channels() const { return plant_channels; }
    const ParameterCoding& coding() const { return coding_; }

    template <BinaryString G>
    PoleZeroPlant plant(const G& genome) const {
        return plant_of<double>(genome);
    }
    template <BinaryString G>
    std::vector<double> decode(const G& genome) const {
        return coding_.decode(genome);
    }
    template <BinaryString G>
    double error(const G& genome, std::span<const double> sample) const {
        auto weights = plant(genome).weights();
        return error_of<double>(weights, sample);
    }

    /// Returns the weights instead of d, alpha, ..., because error_of() for Lanes cannot use the delay as an index.
    template <BinaryString G>
    std::array<double, plant_channels - 1> parameters_of(const G& genome) const {
        return plant(genome).weights();
    }
    template <std::size_t width, bool gray>
    auto parameters_of_several(const StringsInLanes<width, gray>& strings) const {
        return plant_of<Lanes<width>>(strings).weights();
    }
    template <typename T>
    T error_of(std::span<const T> weights, std::span<const double> sample) const {
        return sample[0] - predicted(weights, sample[1], sample[2], sample);
    }

    std::vector<std::string> parameter_names() const { return {"d", "alpha", "beta", "gamma", "delta", "b0"}; }
    std::vector<std::string> parameter_units() const { return {"samples", "", "", "", "", ""}; }

    /// Returns the predicted output y-hat(k). `last` and `before` are y(k-1) and y(k-2), measured or simulated; the
    /// inputs are in `sample`.
    template <typename T, typename Output>
    static T predicted(std::span<const T> weights, const Output& last, const Output& before,
                       std::span<const double> sample) {
        // Not a loop, which would be slower.
        return weights[0] * last + weights[1] * before + weights[2] * sample[3] + weights[3] * sample[4] +
               weights[4] * sample[5] + weights[5] * sample[6] + weights[6] * sample[7] + weights[7] * sample[8];
    }

private:
    template <typename T, typename Strings>
    PoleZeroPlantOf<T> plant_of(const Strings& strings) const {
        auto value = [&](std::size_t i) { return coding_.value(strings, i); };
        return {value(0), value(1), value(2), value(3), value(4), value(5)};
    }

    ParameterCoding coding_;
};

/// A PlantProblem in which the output y-hat(k) is simulated. At the first sample of a window (the samples of an
/// evaluation), y-hat is computed from two measured outputs. At later samples, y-hat is computed from the y-hat of the
/// two samples before.
class SimulatedPlantProblem : public PlantProblem {
public:
    template <typename T>
    auto errors_along(std::span<const T> weights) const {
        return [weights, last = T(), before = T(), first = true](std::span<const double> sample) mutable {
            if (std::exchange(first, false))
                last = sample[1], before = sample[2];
            before = std::exchange(last, predicted<T>(weights, last, before, sample));
            return sample[0] - last;
        };
    }
};

} // namespace placedpar
