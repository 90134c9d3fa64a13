#include "identification/change_test.hpp"

#include "runtime/random.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <map>
#include <span>

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

/// Neighbouring estimates of a series, which are searched for a change. The scatter is computed from the whole series,
/// so this struct also describes all other estimates of the series. `squares_elsewhere` is the sum of the squared
/// distances of the other estimates from their means, in squared standard errors. `degrees_elsewhere` is the number of
/// degrees of freedom of this sum.
struct Part {
    std::span<const UncertainValue> estimates;
    double squares_elsewhere = 0;
    std::size_t degrees_elsewhere = 0;
};

/// A possible change in a Part, just before the estimate with index `at`. The sums are over the estimates before the
/// change and after the change.
struct Split {
    std::size_t at = 0;
    Sums before, after;

    /// Returns the mean square of the estimates' distances from the means, in squared standard errors. The mean square
    /// is about 1 if the standard errors are right. Returns 1 for two estimates, which do not determine the scatter.
    double scatter(const Part& part) const {
        const std::size_t degrees = part.estimates.size() - 2 + part.degrees_elsewhere;
        const double squares = before.scatter() + after.scatter() + part.squares_elsewhere;
        return degrees > 0 ? squares / static_cast<double>(degrees) : 1;
    }
    /// Returns the difference of the means, divided by its standard error.
    double quotient() const {
        const UncertainValue first = before.mean(), second = after.mean();
        return std::abs(second.value - first.value) / std::hypot(first.standard_error, second.standard_error);
    }
};

/// Selects the errors by which the difference of the means is divided: the standard errors of the estimates, or errors
/// computed from the scatter of the estimates.
enum class ErrorsBy { standard_errors, scatter };

struct BestSplit {
    Split split;
    double quotient = -1;
};

BestSplit best_split(const Part& part, ErrorsBy errors) {
    Sums all, before;
    for (const UncertainValue& each : part.estimates)
        all.add(each);
    BestSplit best;
    for (std::size_t at = 1; at < part.estimates.size(); ++at) {
        before.add(part.estimates[at - 1]);
        const Split split{at, before, all - before};
        const double scatter = errors == ErrorsBy::scatter ? split.scatter(part) : 1;
        if (const double quotient = split.quotient() / std::sqrt(scatter); quotient > best.quotient)
            best = {split, quotient};
    }
    return best;
}

/// Returns the share of random parts without a change in which the best split has at least this quotient by chance.
/// Stops counting when the share exceeds `level`.
double probability_of(double quotient, const Part& part, ErrorsBy errors, double level) {
    RandomStream random(1, "series without a change");
    std::vector<UncertainValue> estimates(part.estimates.begin(), part.estimates.end());
    std::size_t as_great = 0;
    const auto most = static_cast<std::size_t>(level * (made_up_series + 1));
    for (std::size_t i = 0; i < made_up_series && as_great < most; ++i) {
        for (UncertainValue& each : estimates)
            each.value = each.standard_error * random.normal();
        Part made_up{estimates, 0, part.degrees_elsewhere};
        for (std::size_t k = 0; errors == ErrorsBy::scatter && k < part.degrees_elsewhere; ++k) {
            const double distance = random.normal();
            made_up.squares_elsewhere += distance * distance;
        }
        as_great += best_split(made_up, errors).quotient >= quotient;
    }
    return static_cast<double>(as_great + 1) / (made_up_series + 1);
}

/// A series, and the changes that were found in it.
class ChangingSeries {
public:
    explicit ChangingSeries(const std::vector<UncertainValue>& series)
        : series_(series), zero_(series.empty() ? 0 : series.front().value) {
        for (UncertainValue& each : series_) // shifts the values to near 0, so that the sums of squares lose no digits
            each.value -= zero_;
    }

    /// Looks for one more change in the series. Returns whether it has found a change.
    bool split(double level) {
        for (std::size_t part = 0; part <= probabilities_.size(); ++part)
            if (split_part(part, level))
                return true;
        return false;
    }
    std::vector<SeriesChange> changes() const {
        const double factor = std::sqrt(std::max(1.0, scatter()));
        auto mean = [&](std::size_t part) {
            const UncertainValue found = sums_of(part).mean();
            return UncertainValue{zero_ + found.value, factor * found.standard_error};
        };
        std::vector<SeriesChange> all;
        for (const auto& [at, probability] : probabilities_)
            all.push_back({at, mean(all.size()), mean(all.size() + 1), probability});
        return all;
    }

private:
    std::span<const UncertainValue> part(std::size_t number) const {
        const auto next = std::next(probabilities_.begin(), static_cast<std::ptrdiff_t>(number));
        const std::size_t first = number == 0 ? 0 : std::prev(next)->first;
        return std::span(series_).subspan(first, (next == probabilities_.end() ? series_.size() : next->first) - first);
    }
    Sums sums_of(std::size_t number) const {
        Sums sums;
        for (const UncertainValue& each : part(number))
            sums.add(each);
        return sums;
    }
    double squares() const {
        double sum = 0;
        for (std::size_t number = 0; number <= probabilities_.size(); ++number)
            sum += sums_of(number).scatter();
        return sum;
    }
    /// Returns the mean square of the estimates' distances from the means of their parts, in squared standard errors.
    /// If the series is too short, returns 1.
    double scatter() const {
        const bool tells = series_.size() >= fewest_for_scatter && series_.size() > probabilities_.size() + 1;
        return tells ? squares() / static_cast<double>(series_.size() - probabilities_.size() - 1) : 1;
    }
    bool split_part(std::size_t number, double level) {
        const std::span<const UncertainValue> estimates = part(number);
        if (estimates.size() < 2)
            return false;
        const Part tested{estimates, squares() - sums_of(number).scatter(),
                          series_.size() - estimates.size() - probabilities_.size()};
        BestSplit best = best_split(tested, ErrorsBy::standard_errors);
        const bool scatters = series_.size() >= fewest_for_scatter && best.split.scatter(tested) > 1;
        const ErrorsBy errors = scatters ? ErrorsBy::scatter : ErrorsBy::standard_errors;
        if (scatters)
            best = best_split(tested, errors);
        const double probability = probability_of(best.quotient, tested, errors, level);
        if (probability > level)
            return false;
        const auto first = static_cast<std::size_t>(estimates.data() - series_.data());
        probabilities_[first + best.split.at] = probability;
        return true;
    }

    std::vector<UncertainValue> series_;
    double zero_; ///< number that was subtracted from all values
    std::map<std::size_t, double>
        probabilities_; ///< probability of each change, by the index of the first estimate after it
};

} // namespace

std::optional<SeriesChange> find_change(const std::vector<UncertainValue>& series, double level) {
    ChangingSeries changing(series);
    if (!changing.split(level))
        return std::nullopt;
    return changing.changes().front();
}

std::vector<SeriesChange> find_changes(const std::vector<UncertainValue>& series, double level) {
    ChangingSeries changing(series);
    while (changing.split(level))
        continue;
    return changing.changes();
}

} // namespace placedpar::identification
