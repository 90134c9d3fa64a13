#pragma once

#include <vector>

namespace placedpar {

/// The result of a test whether groups of figures differ, such as the results of two search methods. The tests use only
/// the ranks of the figures, and so need no assumption about the distribution.
struct RankTest {
    /// Probability of a difference at least as large as the observed difference, if all groups come from one
    /// distribution.
    double p = 1;
    /// The size of the difference. For two groups, `effect` is the probability that a figure of the first group is
    /// greater than a figure of the second group; equal figures count as a half (A of A. Vargha and H. Delaney, 2000).
    /// Then 0.5 means no difference, and 0 or 1 means that the groups do not overlap. For more groups, `effect` is
    /// epsilon squared, from 0 to 1 (M. Tomczak and E. Tomczak, 2014).
    double effect = 0.5;
    bool exact = false; ///< true: p was computed by counting all orders of the figures; false: p is an approximation
};

/// Returns the result of the two-sided test of H. Mann and D. Whitney (1947). Counts all orders of the figures if there
/// are at most 40: the sum of the first group's ranks is at least as far from its mean in a share p of the orders.
/// Equal figures have the mean of their ranks. With more figures, uses the normal distribution, corrected for equal
/// figures and for continuity. REQUIRES: both groups have figures; no figure is NaN.
RankTest mann_whitney(const std::vector<double>& first, const std::vector<double>& second);

/// Returns the result of the test of W. Kruskal and W. Wallis (1952), by the chi-squared distribution, corrected for
/// equal figures. REQUIRES: at least two groups; each group has figures; no figure is NaN.
RankTest kruskal_wallis(const std::vector<std::vector<double>>& groups);

} // namespace placedpar
