#pragma once

#include "gaprocs/fitness.hpp"
#include "problems/plant/plant_problem.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

// This header declares the task and the results of every contestant. The only Boost headers that it includes are
// containers, since a rival may use another version of Boost.

namespace placedpar {

/// The task: follow the pole of chapter 5's plant while the plant changes. There are three generations of 100
/// individuals for each new sample, and the fitness is summed over the newest 30 samples.
struct Chase {
    std::vector<std::vector<double>> record; // as plant_record() returns it
    std::uint64_t seed = 0;                  // seed of the contestant's random numbers

    static constexpr std::size_t population = 100, window = 30, trials = 3;
    static constexpr double bias = 10, crossover = 0.8, mutation = 0.01;
    /// The ranges of Table 5.1's parameters, for rivals that search real numbers; the delay is rounded down.
    static constexpr std::array<double, 6> low{1, -1, -1, -1, -1, 0}, high{4.999, 1, 1, 1, 1, 2};

    /// Returns the number of windows. Each window gets `trials` generations.
    std::size_t windows() const { return record.size() + 1 - window; }
    std::span<const std::vector<double>> window_at(std::size_t number) const {
        return std::span(record).subspan(number, window);
    }
    std::size_t generations() const { return windows() * trials; }
    std::uint64_t error_evaluations() const { return generations() * population * window; }

    /// Computes the fitness by hand-written code, which is the fastest way for a contestant without the library.
    static double fitness(const PoleZeroPlant& plant, std::span<const std::vector<double>> samples) {
        const auto weights = plant.weights();
        double sum = 0;
        for (const std::vector<double>& sample : samples) {
            double predicted = 0;
            for (std::size_t i = 0; i < weights.size(); ++i)
                predicted += weights[i] * sample[i + 1];
            sum += fitness_term(bias, sample[0] - predicted);
        }
        return sum;
    }
};

struct Answer {
    std::vector<Pole> poles; // pole of the best individual after the last generation of each window
};

struct Contestant {
    std::string name;
    Answer (*follow)(const Chase&);
};

std::vector<Contestant> ours();
std::vector<Contestant> galib();
std::vector<Contestant> pagmo();

} // namespace placedpar
