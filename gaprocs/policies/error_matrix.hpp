#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace placedpar {

/// The errors of the best individuals of several islands. Island i has the i-th window, and A_i is its best.
struct ErrorsOfBest {
    std::vector<std::size_t> windows;        ///< in samples, none longer than the errors known
    std::vector<std::vector<double>> errors; ///< [j]: y - y-hat of A_j at each sample, oldest first, the newest for all
    /// [i][j]: of A_j in window i, where errors depend on where their window begins; else none.
    std::vector<std::vector<std::vector<double>>> by_window = {};

    /// Errors of the best individual of an island at each sample of a window.
    std::span<const double> in_window(std::size_t window, std::size_t island) const {
        return by_window.empty() ? std::span(errors[island]).last(windows[window])
                                 : std::span(by_window[window][island]);
    }
};

/// The matrix of Figure 5.2: Error(w_i, A_j), of the newest w_i samples, in row i and column j.
class ErrorMatrix {
public:
    /// How the errors of a window become one number.
    enum class Sum : unsigned char {
        squares, ///< sum of (y - y-hat)^2, as in the fitness 5.1
        plain,   ///< |sum of (y - y-hat)|, as 5.2 and 5.3 print it: errors of both signs cancel
        means,   ///< the mean of (y - y-hat)^2, so that windows of different lengths compare
    };
    /// What an error is divided by.
    enum class Normaliser : unsigned char {
        column, ///< Error(w_j, A_j), as 5.3 and 5.4 print it: that of the same A in the window it was bred in
        row,    ///< Error(w_i, A_i): that of the window's own A, so that one row compares islands in one window
    };

    /// REQUIRES: as many errors as windows, each at least as many as the longest window.
    ErrorMatrix(const ErrorsOfBest& bests, Sum sum);

    std::size_t islands() const { return islands_; }
    double error(std::size_t window, std::size_t island) const { return errors_[window * islands_ + island]; }
    /// Returns |Error(w_i, A_j)| divided by the normaliser. Errors below 1e-12 count as 1e-12, so that two perfect
    /// islands are equals; errors above 1e100, or that are not a number, count as 1e100.
    double normalised(std::size_t window, std::size_t island, Normaliser normaliser) const;

    /// Returns SA_j of 5.3: the sum of column j, A_j in all windows.
    double sum_over_windows(std::size_t island, Normaliser normaliser) const;
    /// Returns Sw_i of 5.4: the sum of row i, all A in window w_i.
    double sum_over_islands(std::size_t window, Normaliser normaliser) const;
    /// Returns Sw_i / SA_i of 5.7.
    double ratio(std::size_t island, Normaliser normaliser) const;

private:
    std::size_t islands_;
    std::vector<double> errors_; ///< row by row
};

} // namespace placedpar
