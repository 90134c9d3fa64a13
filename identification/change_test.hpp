#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace placedpar::identification {

/// A value and its standard error.
struct UncertainValue {
    double value, standard_error;
};

/// A change between two neighbouring estimates of a series.
struct SeriesChange {
    std::size_t at;               ///< index of the first estimate after the change
    UncertainValue before, after; ///< weighted means on both sides; their errors come from the standard errors of the
                                  ///< series, or from its scatter
    double probability;           ///< probability of at least so large a difference if nothing has changed
};

/// In a series of fewer estimates, only the standard errors are used. The scatter of so few estimates could not show
/// that the standard errors are too small.
inline constexpr std::size_t fewest_for_scatter = 6;

/// Looks for the one change that explains a series best. For each place, the difference of the weighted means before
/// and after the place is divided by its standard error. If the estimates scatter around the two means more than their
/// standard errors allow, the scatter replaces the standard errors. The greatest of these quotients is compared with
/// the quotients of 9,999 made-up series that do not change, with normal errors in the same proportions. A change is
/// returned only if its probability is at most `level`. So in about this share of all series without a change, a change
/// is returned by mistake. `level` should be at least 0.001. Equal series give equal results.
std::optional<SeriesChange> find_change(const std::vector<UncertainValue>& series, double level);

/// Finds all changes: looks for one change in the series, then for further changes in the parts before and after each
/// change. For each part, the scatter is computed from the whole series. Returns the changes in order; the means before
/// and after a change extend to the neighbouring changes.
std::vector<SeriesChange> find_changes(const std::vector<UncertainValue>& series, double level);

} // namespace placedpar::identification
