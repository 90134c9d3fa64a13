#pragma once

#include <Eigen/Dense>
#include <Eigen/Sparse>

#include <vector>

namespace placedpar::identification {

using Sparse = Eigen::SparseMatrix<double>;

/// By how much the fourth differences of white noise, and of the 5-point slopes of white noise, have a greater
/// variance.
inline constexpr double white_gain = 70, slope_gain = 25.2;

/// The variance of what is noise in readings, by the median of their fourth differences, which are next to 0 of what is
/// smooth. Ripple counts: it spoils the readings as noise does. REQUIRES: at least five readings.
double noise_variance(const std::vector<double>& readings, double gain);

/// What a reading's noise of variance 1 does to rows: a column an instant at which something is read, from two before
/// the first sample to two after the last. `by` says what it changes, a column a sample: as it is read, or as the
/// 5-point slopes of what is read.
Sparse white_noise(const Eigen::MatrixXd& by);
Sparse slope_noise(const Eigen::MatrixXd& by);

/// Linear equations missed + slopes * unknowns = 0 whose errors come from noises of variance 1.
struct NoisyRows {
    Eigen::MatrixXd slopes;
    Eigen::VectorXd missed;
    Sparse covariance;

    /// `least_variance`: of errors that no reading's noise makes.
    NoisyRows(Eigen::Index rows, Eigen::Index unknowns, double least_variance);
    void add_noise(const Sparse& columns) { covariance += Sparse(columns * columns.transpose()); }
};

/// Generalised least squares of such rows (A. Aitken, Proc. R. Soc. Edinburgh 55, 1935). Slopes that share samples
/// have errors that cancel, over a movement all but for its ends: that is what the covariance knows.
class Weights {
public:
    /// REQUIRES: a least variance above 0.
    explicit Weights(const NoisyRows&);

    const Eigen::MatrixXd& information() const { return information_; }
    const Eigen::VectorXd& pull() const { return pull_; }
    /// What of the information of an unknown is noise, whose column of the slopes has these noises.
    double share_of(const Sparse& columns) const;
    /// By how much the variance of what is left with `by` exceeds what is said of it; by as much as a movement knows
    /// better than the noises that were said.
    double scale(const Eigen::VectorXd& by, Eigen::Index unknowns) const;

private:
    const NoisyRows& rows_;
    Eigen::SimplicialLLT<Sparse, Eigen::Lower, Eigen::NaturalOrdering<int>> factor_;
    Eigen::MatrixXd information_;
    Eigen::VectorXd pull_;
};

} // namespace placedpar::identification
