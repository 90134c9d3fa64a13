#pragma once

#include <Eigen/Dense>
#include <Eigen/Sparse>

#include <vector>

namespace placedpar::identification {

using Sparse = Eigen::SparseMatrix<double>;

/// The variance of the fourth differences of white noise is `white_gain` times the variance of the noise. The slopes of
/// lines fitted to 5 readings of white noise are noise, too. The variance of their fourth differences is `slope_gain`
/// times the variance of the slopes.
inline constexpr double white_gain = 70, slope_gain = 25.2;

/// Estimates the variance of the noise in readings from the median of their fourth differences, which are near 0 for a
/// smooth signal. Ripple of the pump counts as noise, since it disturbs readings in the same way. REQUIRES: at least
/// five readings.
double noise_variance(const std::vector<double>& readings, double gain);

/// These functions return how the noise of each reading changes the equations of NoisyRows. The noises of two readings
/// are independent. For white_noise(), the variance of the readings is 1. For slope_noise(), the variance of their
/// slopes is 1, by lines fitted to 5 readings. `by` has a column per sample: the change of the equations per unit of
/// the reading or of the slope. The result has a column per reading, from two readings before the first sample to two
/// after the last sample.
Sparse white_noise(const Eigen::MatrixXd& by);
Sparse slope_noise(const Eigen::MatrixXd& by);

/// The linear equations `missed` + `slopes` * unknowns = 0, whose errors have the covariance `covariance`. A fit of a
/// movement solves them for a link's deviations.
struct NoisyRows {
    Eigen::MatrixXd slopes;
    Eigen::VectorXd missed;
    Sparse covariance;

    /// `least_variance` is the variance of errors from other causes than the noise of readings.
    NoisyRows(Eigen::Index rows, Eigen::Index unknowns, double least_variance);
    void add_noise(const Sparse& columns) { covariance += Sparse(columns * columns.transpose()); }
};

/// Solves NoisyRows by generalised least squares (A. Aitken, Proc. R. Soc. Edinburgh 55, 1935). Successive slopes share
/// readings, so their errors cancel over a movement, except at its ends. The covariance accounts for this effect.
class Weights {
public:
    /// REQUIRES: the rows were made with a `least_variance` above 0.
    explicit Weights(const NoisyRows&);

    const Eigen::MatrixXd& information() const { return information_; }
    const Eigen::VectorXd& pull() const { return pull_; }
    /// Returns the part of the information about an unknown that comes only from noise. `columns` is the noise in this
    /// unknown's column of `slopes`.
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
