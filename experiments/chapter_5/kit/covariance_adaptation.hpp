#pragma once

#include "experiments/chapter_5/kit/differential_evolution.hpp"
#include "runtime/random.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace placedpar {

/// The evolution strategy CMA-ES, as a baseline for the genetic algorithms. It has the rank-one update, rank-mu update
/// and the usual constants (N. Hansen, "The CMA evolution strategy: a tutorial", 2016). The search starts at the middle
/// of the unit cube. The value of a point outside the cube is the objective at the nearest point of the cube, plus the
/// squared distance to this point.
class CovarianceAdaptation {
public:
    /// `least_step` is the lower limit of the points' standard deviation along their longest axis. With a positive
    /// limit the search never stops exploring, so it can follow a changing objective. REQUIRES: a population of at
    /// least four points.
    CovarianceAdaptation(std::size_t dimensions, std::size_t population, double least_step, RandomStream random);

    /// Makes a generation, with one evaluation for each point.
    void next_generation(const Objective01& minimised);
    /// Returns the mean of the distribution from which the next points are drawn, moved into the cube.
    Eigen::VectorXd mean() const;

private:
    void move(const std::vector<Eigen::VectorXd>& best_steps);
    /// Scales the longest axis of the shape to 1, and multiplies the step by the axis's former length. The step is at
    /// least `least_step_` afterwards.
    void give_step_the_length();
    void adapt(const std::vector<Eigen::VectorXd>& best_steps, const Eigen::VectorXd& way);

    RandomStream random_;
    std::size_t population_;
    double least_step_, step_ = 0.3;
    Eigen::VectorXd weights_, mean_, step_path_, shape_path_;
    Eigen::MatrixXd shape_;
    double effective_, step_damping_, step_memory_, shape_memory_, rank_one_, rank_mu_, expected_length_;
};

} // namespace placedpar
