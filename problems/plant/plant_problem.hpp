#pragma once

#include "gaprocs/representation/parameter_coding.hpp"
#include "problems/plant/plant_record.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace placedpar {

/// A plant in pole-zero form (thesis eq. 5.9): poles alpha +- j beta, zeros gamma +- j delta, gain b0, delay d.
///
/// The plant of 5.8 has the zeros 0 and -.5, which are no conjugate pair: here a negative delta stands for the real
/// pair gamma +- |delta|, so that gamma = delta = -.25 is exactly that plant.
struct PoleZeroPlant {
    double d, alpha, beta, gamma, delta, b0;

    /// What y-hat(k) is made of: of y(k-1), y(k-2), u(k-1), ..., u(k-6).
    std::array<double, plant_channels - 1> weights() const {
        auto delay = static_cast<std::size_t>(d);
        std::array<double, plant_channels - 1> weights{2 * alpha, -(alpha * alpha + beta * beta)};
        weights[1 + delay] = b0;
        weights[2 + delay] = -2 * gamma * b0;
        weights[3 + delay] = (gamma * gamma + std::copysign(delta * delta, delta)) * b0;
        return weights;
    }
};

/// d, alpha, beta, gamma, delta, b0 of a plant: the zeros 0 and -b1 are a real pair. REQUIRES: complex poles.
std::vector<double> parameters_of(const Plant& plant);

/// Identification of that plant as a search problem: the string d | alpha | beta | gamma | delta | b0 of 37 bits
/// (Table 5.1), the error y(k) - y-hat(k) predicted from measured past outputs. A sample is plant_record's.
class PlantProblem {
public:
    PlantProblem();

    std::size_t bits() const { return coding_.bits(); }
    std::size_t channels() const { return plant_channels; }
    const ParameterCoding& coding() const { return coding_; }

    template <BinaryString G>
    PoleZeroPlant plant(const G& genome) const {
        auto value = [&](std::size_t i) { return coding_.value(genome, i); };
        return {value(0), value(1), value(2), value(3), value(4), value(5)};
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

    /// What a population is evaluated by: the weights, so that the delay is no index.
    template <BinaryString G>
    std::array<double, plant_channels - 1> parameters_of(const G& genome) const {
        return plant(genome).weights();
    }
    template <typename T>
    T error_of(std::span<const T> weights, std::span<const double> sample) const {
        // Written out: a loop takes longer.
        T predicted = weights[0] * sample[1] + weights[1] * sample[2] + weights[2] * sample[3] +
                      weights[3] * sample[4] + weights[4] * sample[5] + weights[5] * sample[6] +
                      weights[6] * sample[7] + weights[7] * sample[8];
        return sample[0] - predicted;
    }

    std::vector<std::string> parameter_names() const { return {"d", "alpha", "beta", "gamma", "delta", "b0"}; }
    std::vector<std::string> parameter_units() const { return {"samples", "", "", "", "", ""}; }

private:
    ParameterCoding coding_;
};

} // namespace placedpar
