#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace placedpar {

/// The errors of the best individuals of several islands. Window w_i belongs to island i, and A_i is the best
/// individual of island i.
struct ErrorsOfBest {
    std::vector<std::size_t> windows;        ///< lengths in samples, at most the number of known errors
    std::vector<std::vector<double>> errors; ///< [j]: errors y - y-hat of A_j at each sample, from the oldest to the
                                             ///< newest
    /// [i][j]: errors of A_j in window w_i. Only filled if errors depend on the first sample of their window; otherwise
    /// empty.
    std::vector<std::vector<std::vector<double>>> by_window = {};

    /// Returns the errors of an island's best individual at each sample of a window.
    std::span<const double> in_window(std::size_t window, std::size_t island) const {
        return by_window.empty() ? std::span(errors[island]).last(windows[window])
                                 : std::span(by_window[window][island]);
    }
};

/// The matrix of Figure 5.2. Row i and column j hold Error(w_i, A_j), the error of A_j over the newest w_i samples.
class ErrorMatrix {
public:
    /// The rule by which the errors of a window become one number.
    enum class Sum : unsigned char {
        squares, ///< sum of (y - y-hat)^2, as in the fitness of eq. 5.1
        plain,   ///< |sum of (y - y-hat)|, as printed in eq. 5.2 and 5.3; errors of opposite signs cancel
        means,   ///< mean of (y - y-hat)^2, which makes windows of different lengths comparable
    };
    /// The error by which the errors are divided.
    enum class Normaliser : unsigned char {
        column, ///< Error(w_j, A_j), as printed in eq. 5.3 and 5.4: the error of the same individual in the window of
                ///< its own island
        row,    ///< Error(w_i, A_i): the error of the individual that was bred in the same window
    };

    /// REQUIRES: there is one individual for each window, and it has an error for each sample of the longest window.
    ErrorMatrix(const ErrorsOfBest& bests, Sum sum);

    std::size_t islands() const { return islands_; }
    double error(std::size_t window, std::size_t island) const { return errors_[window * islands_ + island]; }
    /// Returns |Error(w_i, A_j)| divided by the normaliser. Errors below 1e-12 count as 1e-12, so two perfect islands
    /// are equal. Errors above 1e100, and errors that are not numbers, count as 1e100.
    double normalised(std::size_t window, std::size_t island, Normaliser normaliser) const;

    /// Returns SA_j of eq. 5.3: the sum of column j, which holds A_j in all windows.
    double sum_over_windows(std::size_t island, Normaliser normaliser) const;
    /// Returns Sw_i of eq. 5.4: the sum of row i, which holds all individuals in window w_i.
    double sum_over_islands(std::size_t window, Normaliser normaliser) const;
    /// Returns Sw_i / SA_i of eq. 5.7.
    double ratio(std::size_t island, Normaliser normaliser) const;

private:
    std::size_t islands_;
    std::vector<double> errors_; ///< row by row
};

} // namespace placedpar
