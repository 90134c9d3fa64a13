#pragma once

#include <Eigen/Dense>
#include <Eigen/Sparse>

#include <vector>

namespace placedpar::identification {

using Sparse = Eigen::SparseMatrix<double>;

/// The factors by which fourth differences increase the variance of white noise, and of the 5-point slopes of white
/// noise.
inline constexpr double white_gain = 70, slope_gain = 25.2;

/// Estimates the variance of the noise in readings from the median of their fourth differences, which are near 0 for a
/// smooth signal. Ripple counts as noise, since it disturbs readings in the same way. REQUIRES: at least five readings.
double noise_variance(const std::vector<double>& readings, double gain);

/// These functions return the effect of noise of variance 1 in the readings on the rows. The result has a column per
/// instant of reading, from two before the first sample to two after the last. `by` has a column per sample: the effect
/// of the reading itself for white_noise(), of the 5-point slope of the readings for slope_noise().
Sparse white_noise(const Eigen::MatrixXd& by);
Sparse slope_noise(const Eigen::MatrixXd& by);

/// Linear equations missed + slopes * unknowns = 0 whose errors come from noises of variance 1.
struct NoisyRows {
    Eigen::MatrixXd slopes;
    Eigen::VectorXd missed;
    Sparse covariance;

    /// `least_variance` is the variance of errors that do not come from readings.
    NoisyRows(Eigen::Index rows, Eigen::Index unknowns, double least_variance);
    void add_noise(const Sparse& columns) { covariance += Sparse(columns * columns.transpose()); }
};

/// Solves NoisyRows by generalised least squares (A. Aitken, Proc. R. Soc. Edinburgh 55, 1935). Slopes that share
/// readings have errors that cancel over a movement, except at its ends; the covariance accounts for this effect.
class Weights {
public:
    /// REQUIRES: the rows have a least variance above 0.
    explicit Weights(const NoisyRows&);

    const Eigen::MatrixXd& information() const { return information_; }
    const Eigen::VectorXd& pull() const { return pull_; }
    /// Returns the part of an unknown's information that is noise. `columns` is the noise in this unknown's column of
    /// slopes.
    double share_of(const Sparse& columns) const;
    /// Returns the factor by which the variance of the residuals exceeds the assumed variance, if the unknowns are
    /// `by`. With more rows, the residuals outweigh the assumed variance.
    double scale(const Eigen::VectorXd& by, Eigen::Index unknowns) const;

private:
    const NoisyRows& rows_;
    Eigen::SimplicialLLT<Sparse, Eigen::Lower, Eigen::NaturalOrdering<int>> factor_;
    Eigen::MatrixXd information_;
    Eigen::VectorXd pull_;
};

} // namespace placedpar::identification
