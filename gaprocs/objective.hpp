#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace placedpar {

enum class Goal : unsigned char { minimise, maximise };

/// The fitness of an individual whose objective is infinite or NaN. It is the least fitness, but finite, so that the
/// fitness of a whole population can be added up.
inline constexpr double worst_fitness = -0x1p1000;

/// How a problem without measurements rates an individual: by one number, the objective, which is minimised or
/// maximised.
struct Objective {
    Goal goal = Goal::minimise;
    std::string unit = {};
    std::optional<double> optimum = {}; ///< the best possible value, if it is known

    /// Returns the fitness for a value of the objective. Fitness is always maximised, so it is the value, or the
    /// negated value if the objective is minimised, limited to +-2^1000.
    double fitness(double value) const {
        if (!std::isfinite(value))
            return worst_fitness;
        return std::clamp(goal == Goal::maximise ? value : -value, worst_fitness, -worst_fitness);
    }
    /// Returns the value of the objective for a fitness; nothing if the value was not a finite number.
    std::optional<double> value(double fitness) const {
        if (fitness == worst_fitness)
            return std::nullopt;
        return goal == Goal::maximise ? fitness : 0 - fitness;
    }
};

} // namespace placedpar
