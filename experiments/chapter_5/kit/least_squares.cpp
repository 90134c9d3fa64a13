#include "experiments/chapter_5/kit/least_squares.hpp"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>

namespace placedpar {

namespace {

// The initial variance, which is large because nothing is known about the weights.
constexpr double unknown = 1e6;

LinearPlant least_squares_of_delay(std::span<const Sample> window, std::size_t delay) {
    auto rows = static_cast<Eigen::Index>(window.size());
    Eigen::Matrix<double, Eigen::Dynamic, LinearPlant::coefficients> inputs(rows, LinearPlant::coefficients);
    Eigen::VectorXd outputs(rows);
    for (Eigen::Index i = 0; i < rows; ++i) {
        const Sample& sample = window[static_cast<std::size_t>(i)];
        inputs.row(i) = LinearPlant::inputs(sample, delay).transpose();
        outputs[i] = sample[0];
    }
    LinearPlant plant{.delay = delay, .weights = inputs.completeOrthogonalDecomposition().solve(outputs)};
    plant.squared_error = (outputs - inputs * plant.weights).squaredNorm();
    return plant;
}

bool is_better(const LinearPlant& a, const LinearPlant& b) { return a.squared_error < b.squared_error; }

} // namespace

LinearPlant::Coefficients LinearPlant::inputs(const Sample& sample, std::size_t delay) {
    return {sample[1], sample[2], sample[2 + delay], sample[3 + delay], sample[4 + delay]};
}

Pole LinearPlant::pole() const {
    double alpha = weights[0] / 2, squared = -weights[1] - alpha * alpha;
    return squared >= 0 ? Pole{alpha, std::sqrt(squared)} : Pole{alpha + std::sqrt(-squared), 0};
}

LinearPlant least_squares(std::span<const Sample> window) {
    LinearPlant best = least_squares_of_delay(window, 1);
    for (std::size_t delay = 2; delay <= LinearPlant::delays; ++delay)
        best = std::min(best, least_squares_of_delay(window, delay), is_better);
    return best;
}

RecursiveLeastSquares::RecursiveLeastSquares(std::size_t delay, double forgetting, NoiseTerms noise_terms)
    : forgetting_(forgetting), noise_terms_(noise_terms == NoiseTerms::two), plant_{.delay = delay} {
    Eigen::Index size = LinearPlant::coefficients + (noise_terms_ ? 2 : 0);
    weights_ = Eigen::VectorXd::Zero(size);
    covariance_ = unknown * Eigen::MatrixXd::Identity(size, size);
}

void RecursiveLeastSquares::push(const Sample& sample) {
    Eigen::VectorXd inputs(weights_.size());
    inputs.head<LinearPlant::coefficients>() = LinearPlant::inputs(sample, plant_.delay);
    if (noise_terms_)
        inputs.tail<2>() << unexplained_[0], unexplained_[1];
    double error = sample[0] - weights_.dot(inputs);
    Eigen::VectorXd scaled = covariance_ * inputs;
    weights_ += scaled * (error / (forgetting_ + inputs.dot(scaled)));
    covariance_ = (covariance_ - scaled * scaled.transpose() / (forgetting_ + inputs.dot(scaled))) / forgetting_;
    covariance_ = (0.5 * (covariance_ + covariance_.transpose())).eval(); // without this, a forgetting of .9 diverges
    unexplained_ = {sample[0] - weights_.dot(inputs), unexplained_[0]};
    plant_.weights = weights_.head<LinearPlant::coefficients>();
    plant_.squared_error = forgetting_ * plant_.squared_error + error * error;
}

RecursiveIdentification::RecursiveIdentification(double forgetting, RecursiveLeastSquares::NoiseTerms noise_terms) {
    for (std::size_t delay = 1; delay <= LinearPlant::delays; ++delay)
        of_delay_.emplace_back(delay, forgetting, noise_terms);
}

void RecursiveIdentification::push(const Sample& sample) {
    for (RecursiveLeastSquares& each : of_delay_)
        each.push(sample);
}

const LinearPlant& RecursiveIdentification::plant() const {
    auto better = [](const RecursiveLeastSquares& a, const RecursiveLeastSquares& b) {
        return is_better(a.plant(), b.plant());
    };
    return std::ranges::min_element(of_delay_, better)->plant();
}

} // namespace placedpar
