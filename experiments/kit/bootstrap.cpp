#include "experiments/kit/bootstrap.hpp"

#include "runtime/random.hpp"
#include "text/statistics.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace placedpar {

namespace {

constexpr std::size_t bootstrap_samples = 2000;
constexpr double outside = 0.05;

/// Returns the 95 % interval of a statistic of `count` runs that are drawn with replacement. The statistic is computed
/// from the indices of the drawn runs.
template <class Statistic>
Interval bootstrap(std::size_t count, Statistic statistic) {
    if (count < least_runs_for_interval)
        return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    RandomStream random(0, "bootstrap");
    std::vector<double> found;
    std::vector<std::size_t> drawn(count);
    for (std::size_t i = 0; i < bootstrap_samples; ++i) {
        for (std::size_t& each : drawn)
            each = random.below(static_cast<std::uint32_t>(count));
        found.push_back(statistic(drawn));
    }
    return {quantile(found, outside / 2), quantile(found, 1 - outside / 2)};
}

} // namespace

Interval median_interval(const std::vector<double>& values) {
    std::vector<double> sample(values.size());
    return bootstrap(values.size(), [&](const std::vector<std::size_t>& drawn) {
        std::ranges::transform(drawn, sample.begin(), [&](std::size_t i) { return values[i]; });
        return median(sample);
    });
}

Interval quotient_interval(const std::vector<double>& above, const std::vector<double>& below) {
    return bootstrap(above.size(), [&](const std::vector<std::size_t>& drawn) {
        double sum_above = 0, sum_below = 0;
        for (std::size_t i : drawn) {
            sum_above += above[i];
            sum_below += below[i];
        }
        return sum_above / sum_below;
    });
}

} // namespace placedpar
