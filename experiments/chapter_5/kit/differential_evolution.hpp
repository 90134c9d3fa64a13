#pragma once

#include "runtime/random.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <functional>
#include <vector>

namespace placedpar {

/// A function to be minimised; its argument is a point of the unit cube.
using Objective01 = std::function<double(const Eigen::VectorXd&)>;

/// Differential evolution, rand/1/bin (R. Storn and K. Price, 1997), in the unit cube, as a baseline for the genetic
/// algorithms. Points outside the cube are reflected.
class DifferentialEvolution {
public:
    static constexpr double weight = 0.8, crossover = 0.9; ///< F and CR of the paper

    /// Draws a random first population. REQUIRES: at least four points.
    DifferentialEvolution(std::size_t dimensions, std::size_t population, RandomStream random);

    /// Evaluates all points. Call this at the beginning, and whenever the objective has changed.
    void evaluate(const Objective01& minimised);
    /// Makes a generation, with one evaluation for each point. REQUIRES: evaluate() was called.
    void next_generation(const Objective01& minimised);
    /// REQUIRES: evaluate() was called.
    const Eigen::VectorXd& best() const;

private:
    Eigen::VectorXd trial(std::size_t of);

    RandomStream random_;
    std::vector<Eigen::VectorXd> points_;
    std::vector<double> values_;
};

} // namespace placedpar
