#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace placedpar {

enum class Goal : unsigned char { minimise, maximise };

/// The fitness of an individual whose objective (the number to be minimised or maximised) is infinite or NaN. It is the
/// least fitness, but finite, so that the fitness of a whole population can be added up.
inline constexpr double worst_fitness = -0x1p1000;

/// Returns the fitness of an individual with this total violation of constraints. It is less than the fitness of every
/// feasible individual, and decreases with the violation (K. Deb, "An efficient constraint handling method for genetic
/// algorithms", 2000). So selection by ranks or tournaments prefers feasible individuals, and then less violation. NaN
/// counts as an infinite violation. Violations that differ only in the last 10 bits of their doubles have equal
/// fitness. REQUIRES: the violation is above 0, or NaN.
inline double infeasible_fitness(double violation) {
    const double counted = std::isnan(violation) ? std::numeric_limits<double>::infinity() : violation;
    const auto above = std::bit_cast<std::uint64_t>(counted) >> 10; // keeps the fitness above -2^1004
    return -std::bit_cast<double>(std::bit_cast<std::uint64_t>(-2 * worst_fitness) + above);
}

/// The values that decide between two individuals of a problem with constraints or several objectives.
struct Merit {
    bool feasible = false;
    /// Objectives to be minimised; all feasible individuals have the same number of costs.
    std::vector<double> costs = {};
    double violation = 0; ///< total violation of constraints; 0 if feasible
};

/// Returns the total violation of constraints. Each constraint gives a number, which is at most 0 if the constraint is
/// satisfied. The total violation is the sum of the numbers above 0, or infinity if a number is NaN.
inline double violation_of(const std::vector<double>& constraints) {
    double sum = 0;
    for (double each : constraints)
        sum += std::isnan(each) ? std::numeric_limits<double>::infinity() : std::max(each, 0.0);
    return sum;
}

/// Returns the merit of an individual with these objectives. An objective that is not a finite number makes the
/// violation infinite.
inline Merit merit_of(std::vector<double> objectives, double violation, Goal goal) {
    for (double& each : objectives) {
        each = goal == Goal::maximise ? 0 - each : each;
        if (!std::isfinite(each))
            violation = std::numeric_limits<double>::infinity();
    }
    return {.feasible = violation == 0, .costs = std::move(objectives), .violation = violation};
}

/// The objective by which a problem without measurements rates an individual: one number, which is minimised or
/// maximised.
struct Objective {
    Goal goal = Goal::minimise;
    std::string unit = {};
    std::optional<double> optimum = {}; ///< the best possible value, if it is known

    /// Returns the fitness for a value of the objective. Fitness is always maximised, so a value that is minimised is
    /// negated. Fitness is limited to +-2^1000.
    double fitness(double value) const {
        if (!std::isfinite(value))
            return worst_fitness;
        return std::clamp(goal == Goal::maximise ? value : -value, worst_fitness, -worst_fitness);
    }
    /// Returns the value of the objective that has this fitness; nothing if the value was not a finite number, or if
    /// the individual violates constraints.
    std::optional<double> value(double fitness) const {
        if (fitness <= worst_fitness)
            return std::nullopt;
        return goal == Goal::maximise ? fitness : 0 - fitness;
    }
};

} // namespace placedpar
