#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace placedpar {

/// The errors of the best individuals of several islands, from which one island is chosen (thesis 5.3.2). w_i is the
/// length of island i's window, the newest samples over which island i evaluates individuals. A_i is the best
/// individual of island i.
struct ErrorsOfBest {
    std::vector<std::size_t> windows; ///< w_i of each island; none is longer than the lists in `errors`
    /// [j]: errors y - y-hat (measured less computed value) of A_j at the newest samples, oldest first.
    std::vector<std::vector<double>> errors;
    /// [i][j]: errors of A_j in window w_i. Only for problems whose error at a sample depends on where the window
    /// begins; otherwise empty.
    std::vector<std::vector<std::vector<double>>> by_window = {};

    /// Returns the errors of the best individual of `island` at the samples of the window of island `window`.
    std::span<const double> in_window(std::size_t window, std::size_t island) const {
        return by_window.empty() ? std::span(errors[island]).last(windows[window])
                                 : std::span(by_window[window][island]);
    }
};

/// The matrix of Figure 5.2 compares the islands' best individuals in the windows of all islands. Row i and column j
/// hold Error(w_i, A_j), the error of A_j over the newest w_i samples.
class ErrorMatrix {
public:
    /// How Error(w_i, A_j) is computed from the errors at the samples of a window.
    enum class Sum : unsigned char {
        squares, ///< sum of (y - y-hat)^2, as in the fitness of eq. 5.1
        plain,   ///< |sum of (y - y-hat)|, as printed in eq. 5.2 and 5.3; errors of opposite signs cancel
        means,   ///< mean of (y - y-hat)^2, which makes windows of different lengths comparable
    };
    /// The error by which Error(w_i, A_j) is divided, so that different windows or individuals can be compared.
    enum class Normaliser : unsigned char {
        column, ///< Error(w_j, A_j), as printed in eq. 5.3 and 5.4: the error of the same individual in its own
                ///< island's window
        row,    ///< Error(w_i, A_i): the error of island i's own best individual, in the same window
    };

    /// REQUIRES: `bests` has one list of errors for each window, with an error for each sample of the longest window.
    ErrorMatrix(const ErrorsOfBest& bests, Sum sum);

    std::size_t islands() const { return islands_; }
    double error(std::size_t window, std::size_t island) const { return errors_[window * islands_ + island]; }
    /// Returns Error(w_i, A_j) divided by the normaliser. Errors below 1e-12 count as 1e-12, so 0 divided by 0 gives 1.
    /// Errors above 1e100, and NaN, count as 1e100.
    double normalised(std::size_t window, std::size_t island, Normaliser normaliser) const;

    /// Returns SA_j of eq. 5.3: the sum of the normalised errors in column `island`, over all windows.
    double sum_over_windows(std::size_t island, Normaliser normaliser) const;
    /// Returns Sw_i of eq. 5.4: the sum of the normalised errors in row `window`, over all islands.
    double sum_over_islands(std::size_t window, Normaliser normaliser) const;
    /// Returns Sw_i / SA_i of eq. 5.7, by which an island is chosen.
    double ratio(std::size_t island, Normaliser normaliser) const;

private:
    std::size_t islands_;
    std::vector<double> errors_; ///< row by row
};

} // namespace placedpar
