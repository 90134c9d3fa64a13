#pragma once

#include <Eigen/Dense>
#include <Eigen/Sparse>

#include <vector>

namespace placedpar::identification {

using Sparse = Eigen::SparseMatrix<double>;

/// The factors by which taking fourth differences increases the variance of white noise (`white_gain`), and of the
/// 5-point slopes of white noise (`slope_gain`).
inline constexpr double white_gain = 70, slope_gain = 25.2;

/// Estimates the variance of the noise in readings from the median of their fourth differences, which are near 0 for a
/// smooth signal. Ripple counts as noise, since it disturbs readings in the same way. REQUIRES: at least five readings.
double noise_variance(const std::vector<double>& readings, double gain);

/// These functions return the effect of noise on the rows. The noise of each reading is independent. Its variance is 1
/// in the readings for white_noise(), and 1 in the 5-point slopes of the readings for slope_noise(). `by` has a column
/// per sample: the change of the rows per unit of the reading or of the slope. The result has a column per reading,
/// from two before the first sample to two after the last.
Sparse white_noise(const Eigen::MatrixXd& by);
Sparse slope_noise(const Eigen::MatrixXd& by);

/// The linear equations `missed` + `slopes` * unknowns = 0, whose errors have the covariance `covariance`.
struct NoisyRows {
    Eigen::MatrixXd slopes;
    Eigen::VectorXd missed;
    Sparse covariance;

    /// `least_variance` is the variance of the errors that the noise of readings does not cause.
    NoisyRows(Eigen::Index rows, Eigen::Index unknowns, double least_variance);
    void add_noise(const Sparse& columns) { covariance += Sparse(columns * columns.transpose()); }
};

/// Solves NoisyRows by generalised least squares (A. Aitken, Proc. R. Soc. Edinburgh 55, 1935). Slopes that share
/// readings have errors that cancel over a movement, except at its ends; the covariance accounts for this effect.
class Weights {
public:
    /// REQUIRES: the rows were made with a `least_variance` above 0.
    explicit Weights(const NoisyRows&);

    const Eigen::MatrixXd& information() const { return information_; }
    const Eigen::VectorXd& pull() const { return pull_; }
    /// Returns the part of an unknown's information that is noise. `columns` is the noise in this unknown's column of
    /// slopes.
    double share_of(const Sparse& columns) const;
    /// Returns the factor by which the variance of the residuals exceeds the assumed variance, if the unknowns are
    /// `by`. With few rows the factor stays near 1.
    double scale(const Eigen::VectorXd& by, Eigen::Index unknowns) const;

private:
    const NoisyRows& rows_;
    Eigen::SimplicialLLT<Sparse, Eigen::Lower, Eigen::NaturalOrdering<int>> factor_;
    Eigen::MatrixXd information_;
    Eigen::VectorXd pull_;
};

} // namespace placedpar::identification
