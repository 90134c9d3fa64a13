#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace placedpar::identification {

/// A value and its standard error, such as an identified compliance.
struct UncertainValue {
    double value, standard_error;
};

/// A change between two neighbouring estimates of a series, such as the compliances of one machine over many days.
struct SeriesChange {
    std::size_t at;               ///< index of the first estimate after the change
    UncertainValue before, after; ///< weighted means on both sides; their standard errors follow from those of the
                                  ///< series, or from its scatter
    double probability;           ///< probability that a series without a change shows at least this difference
};

/// A shorter series is judged by its standard errors alone. The scatter of so few estimates cannot show that the
/// standard errors are too small.
inline constexpr std::size_t fewest_for_scatter = 6;

/// Looks for the one change that explains a series best. For each place between two estimates, computes the difference
/// of the weighted means before and after the place, divided by its standard error. If the estimates scatter around the
/// two means more than their standard errors allow, the scatter replaces the standard errors. Compares the greatest of
/// these quotients with the greatest quotients of 9,999 random series without a change. The errors of the random series
/// are normal and have the standard errors of the series. Returns a change only if its probability is at most `level`.
/// If `level` is 0.01, about 1 % of the series without a change therefore get a change by mistake. `level` should be at
/// least 0.001. Equal series give equal results.
std::optional<SeriesChange> find_change(const std::vector<UncertainValue>& series, double level);

/// Finds all changes: looks for one change in the series, then for further changes in the parts before and after each
/// change. The scatter of each part is that of the whole series. Returns the changes in order. The means before and
/// after a change are over the estimates up to the neighbouring changes.
std::vector<SeriesChange> find_changes(const std::vector<UncertainValue>& series, double level);

} // namespace placedpar::identification
