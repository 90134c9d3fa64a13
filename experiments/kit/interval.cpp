#include "experiments/kit/interval.hpp"

#include "runtime/random.hpp"
#include "text/statistics.hpp"

#include <boost/math/distributions/binomial.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace placedpar {

namespace {

constexpr std::size_t bootstrap_samples = 2000;
constexpr double outside = 0.05, two_sided_normal = 1.959964;

/// E. Wilson's, 1927, as shares.
Interval wilson_interval(double successes, double runs) {
    double share = successes / runs, z2 = two_sided_normal * two_sided_normal / runs;
    double centre = (share + z2 / 2) / (1 + z2);
    double half = two_sided_normal * std::sqrt(share * (1 - share) / runs + z2 / (4 * runs)) / (1 + z2);
    return {centre - half, centre + half};
}

/// Of the statistic of `count` runs drawn with replacement, by their indices.
template <class Statistic>
Interval bootstrap(std::size_t count, Statistic statistic) {
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

Interval success_interval(std::size_t successes, std::size_t runs) {
    using Binomial = boost::math::binomial_distribution<double>;
    auto won = static_cast<double>(successes), all = static_cast<double>(runs);
    return {100 * Binomial::find_lower_bound_on_p(all, won, outside / 2),
            100 * Binomial::find_upper_bound_on_p(all, won, outside / 2)};
}

Interval difference_interval(std::size_t first, std::size_t first_runs, std::size_t second, std::size_t second_runs) {
    auto a = static_cast<double>(first), b = static_cast<double>(second), of_a = static_cast<double>(first_runs),
         of_b = static_cast<double>(second_runs);
    Interval one = wilson_interval(a, of_a), other = wilson_interval(b, of_b);
    double p = a / of_a, q = b / of_b;
    return {100 * (q - p - std::hypot(q - other.low, one.high - p)),
            100 * (q - p + std::hypot(other.high - q, p - one.low))};
}

} // namespace placedpar
