#pragma once

#include "gaprocs/search_problem.hpp"
#include "problems/plant/plant_record.hpp"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace placedpar {

/// A linear plant of second order, y(k) = a1 y(k-1) + a2 y(k-2) + b0 u(k-d) + b1 u(k-d-1) + b2 u(k-d-2): what the plant
/// of chapter 5 is to whoever estimates its coefficients instead of its poles and zeros.
struct LinearPlant {
    static constexpr std::size_t coefficients = 5, delays = 4; ///< d from 1 to 4
    using Coefficients = Eigen::Matrix<double, coefficients, 1>;

    std::size_t delay = 1;
    Coefficients weights = Coefficients::Zero(); ///< a1, a2, b0, b1, b2
    double squared_error = 0;                    ///< what it was chosen for

    /// What the weights belong to in a sample of plant_record.
    static Coefficients inputs(const Sample& sample, std::size_t delay);
    /// The pole with the greatest real part; beta is 0 for a pair of real ones.
    Pole pole() const;
};

/// The plant of the least sum of squared prediction errors over the window: of each delay by a complete orthogonal
/// decomposition (Eigen), of the four the best. So nobody who searches the poles and zeros for that criterion can do
/// better. REQUIRES: a window that is not empty.
LinearPlant least_squares(std::span<const Sample> window);

/// Least squares over all samples, each weighed by forgetting^age, found from sample to sample. With `noise_terms` also
/// c1 e(k-1) + c2 e(k-2) is estimated, e being what the estimate before could not explain (extended least squares), for
/// coloured noise.
class RecursiveLeastSquares {
public:
    enum class NoiseTerms : bool { none, two };

    /// REQUIRES: 0 < forgetting <= 1, a delay of 1 to 4.
    RecursiveLeastSquares(std::size_t delay, double forgetting, NoiseTerms noise_terms = NoiseTerms::none);

    void push(const Sample& sample);
    /// With the sum of squared prediction errors, weighed alike.
    const LinearPlant& plant() const { return plant_; }

private:
    double forgetting_;
    bool noise_terms_;
    LinearPlant plant_;
    Eigen::VectorXd weights_;
    Eigen::MatrixXd covariance_;
    std::array<double, 2> unexplained_{};
};

/// One for each delay; the plant is that of the least error.
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
