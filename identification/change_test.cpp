#include "identification/change_test.hpp"

#include "runtime/random.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace placedpar::identification {

namespace {

constexpr std::size_t made_up_series = 9999;

/// Sums over some estimates, each weighted by the inverse of its variance.
struct Sums {
    double weight = 0, values = 0, squares = 0;

    void add(const UncertainValue& each) {
        const double by = 1 / (each.standard_error * each.standard_error);
        weight += by;
        values += by * each.value;
        squares += by * each.value * each.value;
    }
    friend Sums operator-(const Sums& a, const Sums& b) {
        return {a.weight - b.weight, a.values - b.values, a.squares - b.squares};
    }
    UncertainValue mean() const { return {values / weight, 1 / std::sqrt(weight)}; }
    /// Returns the weighted sum of the squares of the distances from the mean.
    double scatter() const { return std::max(0.0, squares - values * values / weight); }
};

/// A place for a change: the estimates before it, and after it.
struct Split {
    std::size_t at = 0;
    Sums before, after;

    /// Returns the mean square of the distances from the two means, in squared standard errors: about 1 if these are
    /// right. Two estimates do not tell it.
    double scatter(std::size_t size) const {
        return size > 2 ? (before.scatter() + after.scatter()) / static_cast<double>(size - 2) : 1;
    }
    /// Returns the difference of the means, divided by its standard error.
    double quotient() const {
        const UncertainValue first = before.mean(), second = after.mean();
        return std::abs(second.value - first.value) / std::hypot(first.standard_error, second.standard_error);
    }
};

/// Says which errors divide the difference: the standard errors of the estimates, or their scatter.
enum class ErrorsBy { standard_errors, scatter };

struct BestSplit {
    Split split;
    double quotient = -1;
};

BestSplit best_split(const std::vector<UncertainValue>& series, ErrorsBy errors) {
    Sums all, before;
    for (const UncertainValue& each : series)
        all.add(each);
    BestSplit best;
    for (std::size_t at = 1; at < series.size(); ++at) {
        before.add(series[at - 1]);
        const Split split{at, before, all - before};
        const double scatter = errors == ErrorsBy::scatter ? split.scatter(series.size()) : 1;
        if (const double quotient = split.quotient() / std::sqrt(scatter); quotient > best.quotient)
            best = {split, quotient};
    }
    return best;
}

UncertainValue mean_of(const std::vector<UncertainValue>& series, std::size_t first, std::size_t last) {
    Sums sums;
    for (std::size_t i = first; i < last; ++i)
        sums.add(series[i]);
    return sums.mean();
}

/// Appends the changes among the estimates [first, last).
void add_changes(const std::vector<UncertainValue>& series, std::size_t first, std::size_t last, double level,
                 std::vector<SeriesChange>& all) {
    const auto begin = series.begin();
    const auto change =
        find_change({begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(last)}, level);
    if (!change)
        return;
    const std::size_t at = first + change->at;
    add_changes(series, first, at, level, all);
    all.push_back(*change);
    all.back().at = at;
    add_changes(series, at, last, level, all);
}

} // namespace

std::optional<SeriesChange> find_change(const std::vector<UncertainValue>& series, double level) {
    if (series.size() < 2)
        return std::nullopt;
    std::vector<UncertainValue> centred = series; // about 0, so that the sums of squares lose no digits
    for (UncertainValue& each : centred)
        each.value -= series.front().value;
    BestSplit best = best_split(centred, ErrorsBy::standard_errors);
    const ErrorsBy errors = best.split.scatter(series.size()) > 1 ? ErrorsBy::scatter : ErrorsBy::standard_errors;
    if (errors == ErrorsBy::scatter)
        best = best_split(centred, errors);
    RandomStream random(1, "series without a change");
    std::size_t as_great = 0;
    const auto most = static_cast<std::size_t>(level * (made_up_series + 1));
    for (std::size_t i = 0; i < made_up_series && as_great < most; ++i) {
        for (UncertainValue& each : centred)
            each.value = each.standard_error * random.normal();
        as_great += best_split(centred, errors).quotient >= best.quotient;
    }
    const double probability = static_cast<double>(as_great + 1) / (made_up_series + 1);
    if (probability > level)
        return std::nullopt;
    auto moved = [by = series.front().value](UncertainValue mean) {
        return UncertainValue{mean.value + by, mean.standard_error};
    };
    return SeriesChange{best.split.at, moved(best.split.before.mean()), moved(best.split.after.mean()), probability};
}

std::vector<SeriesChange> find_changes(const std::vector<UncertainValue>& series, double level) {
    std::vector<SeriesChange> all;
    add_changes(series, 0, series.size(), level, all);
    for (std::size_t i = 0; i < all.size(); ++i) {
        all[i].before = mean_of(series, i == 0 ? 0 : all[i - 1].at, all[i].at);
        all[i].after = mean_of(series, all[i].at, i + 1 == all.size() ? series.size() : all[i + 1].at);
    }
    return all;
}

} // namespace placedpar::identification
