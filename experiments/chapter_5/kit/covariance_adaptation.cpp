#include "experiments/chapter_5/kit/covariance_adaptation.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace placedpar {

namespace {

double paid_outside(const Objective01& minimised, const Eigen::VectorXd& point) {
    Eigen::VectorXd inside = point.cwiseMax(0.0).cwiseMin(1.0);
    return minimised(inside) + (point - inside).squaredNorm();
}

Eigen::VectorXd normal_vector(Eigen::Index size, RandomStream& random) {
    Eigen::VectorXd vector(size);
    for (double& each : vector)
        each = random.normal();
    return vector;
}

/// Returns the weights with which the better half of a population is recombined. They fall with the logarithm of the
/// rank.
Eigen::VectorXd recombination(std::size_t population) {
    auto parents = static_cast<Eigen::Index>(population / 2);
    Eigen::VectorXd weights(parents);
    for (Eigen::Index i = 0; i < parents; ++i)
        weights[i] = std::log(static_cast<double>(population + 1) / 2) - std::log(static_cast<double>(i + 1));
    return weights / weights.sum();
}

} // namespace

CovarianceAdaptation::CovarianceAdaptation(std::size_t dimensions, std::size_t population, double least_step,
                                           RandomStream random)
    : random_(std::move(random)), population_(population), least_step_(least_step), weights_(recombination(population)),
      mean_(Eigen::VectorXd::Constant(static_cast<Eigen::Index>(dimensions), 0.5)),
      step_path_(Eigen::VectorXd::Zero(mean_.size())), shape_path_(step_path_),
      shape_(Eigen::MatrixXd::Identity(mean_.size(), mean_.size())), effective_(1 / weights_.squaredNorm()) {
    // These are the values of the tutorial's table 1.
    auto n = static_cast<double>(dimensions);
    step_memory_ = (effective_ + 2) / (n + effective_ + 5);
    step_damping_ = 1 + 2 * std::max(0.0, std::sqrt((effective_ - 1) / (n + 1)) - 1) + step_memory_;
    shape_memory_ = (4 + effective_ / n) / (n + 4 + 2 * effective_ / n);
    rank_one_ = 2 / ((n + 1.3) * (n + 1.3) + effective_);
    rank_mu_ = std::min(1 - rank_one_, 2 * (effective_ - 2 + 1 / effective_) / ((n + 2) * (n + 2) + effective_));
    expected_length_ = std::sqrt(n) * (1 - 1 / (4 * n) + 1 / (21 * n * n));
}

void CovarianceAdaptation::next_generation(const Objective01& minimised) {
    Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> axes(shape_);
    Eigen::MatrixXd root = axes.eigenvectors() * axes.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal();
    std::vector<std::pair<double, Eigen::VectorXd>> steps;
    for (std::size_t i = 0; i < population_; ++i) {
        Eigen::VectorXd step = root * normal_vector(mean_.size(), random_);
        double value = paid_outside(minimised, mean_ + step_ * step);
        steps.emplace_back(value, std::move(step));
    }
    std::ranges::stable_sort(steps, {}, &std::pair<double, Eigen::VectorXd>::first);
    std::vector<Eigen::VectorXd> best;
    for (Eigen::Index i = 0; i < weights_.size(); ++i)
        best.push_back(std::move(steps[static_cast<std::size_t>(i)].second));
    move(best);
}

void CovarianceAdaptation::move(const std::vector<Eigen::VectorXd>& best_steps) {
    Eigen::VectorXd way = Eigen::VectorXd::Zero(mean_.size());
    for (Eigen::Index i = 0; i < weights_.size(); ++i)
        way += weights_[i] * best_steps[static_cast<std::size_t>(i)];
    mean_ += step_ * way;
    adapt(best_steps, way);
}

void CovarianceAdaptation::adapt(const std::vector<Eigen::VectorXd>& best_steps, const Eigen::VectorXd& way) {
    Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> axes(shape_);
    step_path_ = (1 - step_memory_) * step_path_ +
                 std::sqrt(step_memory_ * (2 - step_memory_) * effective_) * (axes.operatorInverseSqrt() * way);
    double length = step_path_.norm() / expected_length_;
    bool stalled = length > 1.4 + 2 / static_cast<double>(mean_.size() + 1);
    shape_path_ *= 1 - shape_memory_;
    if (!stalled)
        shape_path_ += std::sqrt(shape_memory_ * (2 - shape_memory_) * effective_) * way;
    double kept = 1 - rank_one_ - rank_mu_ + (stalled ? rank_one_ * shape_memory_ * (2 - shape_memory_) : 0);
    shape_ = (kept * shape_ + rank_one_ * shape_path_ * shape_path_.transpose()).eval();
    for (Eigen::Index i = 0; i < weights_.size(); ++i) {
        const Eigen::VectorXd& step = best_steps[static_cast<std::size_t>(i)];
        shape_ += rank_mu_ * weights_[i] * step * step.transpose();
    }
    shape_ = (0.5 * (shape_ + shape_.transpose())).eval();
    step_ *= std::exp(step_memory_ / step_damping_ * (length - 1));
    give_step_the_length();
}

void CovarianceAdaptation::give_step_the_length() {
    double longest = std::sqrt(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(shape_).eigenvalues().maxCoeff());
    shape_ /= longest * longest;
    shape_path_ /= longest;
    step_ = std::max(least_step_, step_ * longest);
}

Eigen::VectorXd CovarianceAdaptation::mean() const { return mean_.cwiseMax(0.0).cwiseMin(1.0); }

} // namespace placedpar
