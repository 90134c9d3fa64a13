#include "experiments/chapter_5/kit/least_squares.hpp"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

namespace placedpar {

namespace {

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
    : forgetting_(forgetting), noise_terms_(noise_terms == NoiseTerms::two), plant_{.delay = delay},
      estimate_(LinearPlant::coefficients + (noise_terms_ ? 2 : 0)) {}

void RecursiveLeastSquares::push(const Sample& sample) {
    LinearPlant::Coefficients of_plant = LinearPlant::inputs(sample, plant_.delay);
    std::vector<double> inputs(of_plant.begin(), of_plant.end());
    if (noise_terms_)
        inputs.insert(inputs.end(), unexplained_.begin(), unexplained_.end());
    double error = estimate_.take(inputs, sample[0], forgetting_);
    unexplained_ = {std::inner_product(inputs.begin(), inputs.end(), estimate_.weights.begin(), sample[0], std::plus(),
                                       [](double input, double weight) { return -input * weight; }),
                    unexplained_[0]};
    std::copy_n(estimate_.weights.begin(), LinearPlant::coefficients, plant_.weights.begin());
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
