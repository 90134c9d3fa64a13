#include "identification/verdict/noisy_rows.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace placedpar::identification {

using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

constexpr Eigen::Index reach = 2; ///< samples that a 5-point slope uses on either side

/// The effects of the noise at five instants on one sample. The instants are from two samples before this sample to two
/// samples after this sample.
using Taps = std::array<double, 2 * reach + 1>;

Sparse noise_through(const Taps& taps, const MatrixXd& by) {
    std::vector<Eigen::Triplet<double, int>> entries;
    for (Eigen::Index sample = 0; sample < by.cols(); ++sample)
        for (std::size_t tap = 0; tap < taps.size(); ++tap)
            for (Eigen::Index row = 0; row < by.rows(); ++row)
                entries.emplace_back(static_cast<int>(sample * by.rows() + row),
                                     static_cast<int>(sample) + static_cast<int>(tap), taps[tap] * by(row, sample));
    Sparse columns(by.size(), by.cols() + 2 * reach);
    columns.setFromTriplets(entries.begin(), entries.end());
    return columns;
}

/// The weight of the assumed variance in Weights::scale(): the assumption counts as much as the residuals of this
/// number of rows.
constexpr double noise_worth_rows = 8;

} // namespace

double noise_variance(const std::vector<double>& readings, double gain) {
    std::vector<double> differences;
    for (std::size_t i = 4; i < readings.size(); ++i)
        differences.push_back(
            std::abs(readings[i] - 4 * readings[i - 1] + 6 * readings[i - 2] - 4 * readings[i - 3] + readings[i - 4]));
    auto middle = differences.begin() + static_cast<std::ptrdiff_t>(differences.size() / 2);
    std::ranges::nth_element(differences, middle);
    constexpr double median_of_normal = 0.6745;
    return *middle * *middle / (median_of_normal * median_of_normal * gain);
}

Sparse white_noise(const MatrixXd& by) { return noise_through({0, 0, 1, 0, 0}, by); }

Sparse slope_noise(const MatrixXd& by) {
    const double unit = 1 / std::sqrt(10.0); // 10: the sum of the squares of -2 to 2
    return noise_through({-2 * unit, -unit, 0, unit, 2 * unit}, by);
}

NoisyRows::NoisyRows(Eigen::Index rows, Eigen::Index unknowns, double least_variance)
    : slopes(MatrixXd::Zero(rows, unknowns)), missed(VectorXd::Zero(rows)), covariance(rows, rows) {
    covariance.setIdentity();
    covariance *= least_variance;
}

Weights::Weights(const NoisyRows& rows) : rows_(rows), factor_(rows.covariance) {
    const MatrixXd weighted = factor_.solve(rows.slopes);
    information_ = rows.slopes.transpose() * weighted;
    pull_ = -weighted.transpose() * rows.missed;
}

double Weights::share_of(const Sparse& columns) const {
    const MatrixXd noise = columns;
    const MatrixXd weighted = factor_.solve(noise);
    return noise.cwiseProduct(weighted).sum();
}

double Weights::scale(const VectorXd& by, Eigen::Index unknowns) const {
    const VectorXd errors = rows_.missed + rows_.slopes * by;
    const VectorXd weighted = factor_.solve(errors);
    const auto freedom = static_cast<double>(errors.size() - unknowns);
    return (errors.dot(weighted) + noise_worth_rows) / (freedom + noise_worth_rows);
}

} // namespace placedpar::identification
