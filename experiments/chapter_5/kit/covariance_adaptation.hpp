#pragma once

#include "experiments/chapter_5/kit/differential_evolution.hpp"
#include "runtime/random.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace placedpar {

/// CMA-ES with rank-one and rank-mu update and the usual constants (N. Hansen, "The CMA evolution strategy: a
/// tutorial", 2016), from the middle of the unit cube. Points outside of the cube are evaluated at its nearest point
/// and pay their squared distance from it.
class CovarianceAdaptation {
public:
    /// The deviation of the points along their longest axis, in lengths of the cube, does not fall below `least_step`:
    /// a positive one keeps looking around when the objective changes. REQUIRES: a population of four or more.
    CovarianceAdaptation(std::size_t dimensions, std::size_t population, double least_step, RandomStream random);

    /// A generation, as many evaluations as the population has points.
    void next_generation(const Objective01& minimised);
    /// The mean of the points to come, in the cube.
    Eigen::VectorXd mean() const;

private:
    void move(const std::vector<Eigen::VectorXd>& best_steps);
    /// The longest axis of the shape becomes 1, which changes no point.
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
