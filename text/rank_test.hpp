#pragma once

#include <vector>

namespace placedpar {

/// Tests whether groups of figures differ. The test uses only the ranks of the figures, so it assumes no distribution.
struct RankTest {
    /// Probability that ranks differ as much as these, or more, if all groups come from one distribution.
    double p = 1;
    /// The size of the difference. Two groups: A (A. Vargha and H. Delaney, 2000), the probability that a figure of the
    /// first group is greater than a figure of the second group, with equal figures counted as a half: 0.5 for no
    /// difference, 0 or 1 if the groups do not overlap. More groups: epsilon squared, from 0 to 1 (M. Tomczak and E.
    /// Tomczak, 2014).
    double effect = 0.5;
    bool exact = false; ///< true: p was found by counting all orders; false: p is an approximation
};

/// Returns the two-sided test of H. Mann and D. Whitney (1947). It counts all orders if no figures are equal and there
/// are at most 40 figures. Otherwise it uses the normal distribution, corrected for equal figures and for continuity.
/// REQUIRES: figures in both groups; none is NaN.
RankTest mann_whitney(const std::vector<double>& first, const std::vector<double>& second);

/// Returns the test of W. Kruskal and W. Wallis (1952), by the chi-squared distribution, corrected for equal figures.
/// REQUIRES: two groups or more, each with figures; none is NaN.
RankTest kruskal_wallis(const std::vector<std::vector<double>>& groups);

} // namespace placedpar
