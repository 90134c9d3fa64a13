#pragma once

#include "gaprocs/search_problem.hpp"
#include "problems/plant/plant_record.hpp"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace placedpar {

/// A linear plant of second order, y(k) = a1 y(k-1) + a2 y(k-2) + b0 u(k-d) + b1 u(k-d-1) + b2 u(k-d-2). This is the
/// plant of chapter 5, written for methods that estimate coefficients instead of poles and zeros.
struct LinearPlant {
    static constexpr std::size_t coefficients = 5, delays = 4; ///< d from 1 to 4
    using Coefficients = Eigen::Matrix<double, coefficients, 1>;

    std::size_t delay = 1;
    Coefficients weights = Coefficients::Zero(); ///< a1, a2, b0, b1, b2
    double squared_error = 0;                    ///< sum of the plant's squared prediction errors over the samples

    /// Returns the values of a sample of plant_record() that the weights multiply.
    static Coefficients inputs(const Sample& sample, std::size_t delay);
    /// Returns the pole with the greatest real part; beta is 0 for two real poles.
    Pole pole() const;
};

/// Returns the plant with the least sum of squared prediction errors over the window. For each of the four delays,
/// Eigen's complete orthogonal decomposition solves the least-squares problem; the delay with the smallest sum is
/// chosen. No search over poles and zeros can find a plant with a smaller sum. REQUIRES: the window is not empty.
LinearPlant least_squares(std::span<const Sample> window);

/// The state of recursive least squares: the estimated weights and their covariance.
template <typename T>
struct RecursiveEstimate {
    std::vector<T> weights;
    std::vector<T> covariance; ///< symmetric, row by row
    std::vector<T> scaled;     ///< covariance * inputs

    explicit RecursiveEstimate(std::size_t unknowns)
        : weights(unknowns), covariance(unknowns * unknowns), scaled(unknowns) {
        for (std::size_t i = 0; i < unknowns; ++i)
            covariance[i * unknowns + i] = 1e6; // large, because nothing is known about the weights
    }

    /// Updates the estimate with an output and the inputs that the weights multiply. Returns the prediction error of
    /// the output. Only half of the symmetric covariance is computed, and then copied. If both halves were computed,
    /// rounding would make the estimate diverge with a forgetting factor of .9.
    T take(std::span<const T> inputs, T output, T forgetting) {
        const std::size_t size = weights.size();
        T scale = forgetting, error = output;
        for (std::size_t i = 0; i < size; ++i) {
            scaled[i] = covariance[i * size] * inputs[0];
            for (std::size_t j = 1; j < size; ++j)
                scaled[i] += covariance[i * size + j] * inputs[j];
            scale += inputs[i] * scaled[i];
            error -= weights[i] * inputs[i];
        }
        for (std::size_t i = 0; i < size; ++i) {
            T gain = scaled[i] / scale;
            weights[i] += gain * error;
            for (std::size_t j = 0; j <= i; ++j)
                covariance[i * size + j] = covariance[j * size + i] =
                    (covariance[i * size + j] - gain * scaled[j]) / forgetting;
        }
        return error;
    }
};

/// Recursive least squares over all samples, which estimates the coefficients of the plant anew after each sample. The
/// weight of a sample is `forgetting` to the power of the sample's age. For coloured noise, NoiseTerms::two also
/// estimates c1 and c2 in the terms c1 e(k-1) + c2 e(k-2), where e is the residual (extended least squares).
class RecursiveLeastSquares {
public:
    enum class NoiseTerms : bool { none, two };

    /// REQUIRES: 0 < forgetting <= 1, a delay of 1 to 4.
    RecursiveLeastSquares(std::size_t delay, double forgetting, NoiseTerms noise_terms = NoiseTerms::none);

    void push(const Sample& sample);
    /// Returns the plant. In its sum of squared prediction errors, each error has the weight of its sample.
    const LinearPlant& plant() const { return plant_; }

private:
    double forgetting_;
    bool noise_terms_;
    LinearPlant plant_;
    RecursiveEstimate<double> estimate_;
    std::array<double, 2> unexplained_{};
};

/// Runs recursive least squares for each delay, because the delay is unknown. plant() comes from the delay with the
/// least squared error.
class RecursiveIdentification {
public:
    explicit RecursiveIdentification(
        double forgetting, RecursiveLeastSquares::NoiseTerms noise_terms = RecursiveLeastSquares::NoiseTerms::none);

    void push(const Sample& sample);
    const LinearPlant& plant() const;

private:
    std::vector<RecursiveLeastSquares> of_delay_;
};

} // namespace placedpar
