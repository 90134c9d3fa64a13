#include "text/interval.hpp"

#include <boost/math/distributions/binomial.hpp>

#include <cmath>

namespace placedpar {

namespace {

constexpr double outside = 0.05, two_sided_normal = 1.959964;

/// Returns E. Wilson's interval (1927); both limits are shares from 0 to 1.
Interval wilson_interval(double successes, double runs) {
    double share = successes / runs, z2 = two_sided_normal * two_sided_normal / runs;
    double centre = (share + z2 / 2) / (1 + z2);
    double half = two_sided_normal * std::sqrt(share * (1 - share) / runs + z2 / (4 * runs)) / (1 + z2);
    return {centre - half, centre + half};
}

} // namespace

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
