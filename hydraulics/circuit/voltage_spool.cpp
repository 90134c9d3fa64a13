#include "hydraulics/circuit/voltage_spool.hpp"

#include <boost/math/tools/roots.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <utility>

namespace placedpar::hydraulics {

namespace {

// Coefficients of A.1, in inches per power of a volt.
constexpr double cubic = 0.0892, quadratic = 0.2352, linear = 0.2815, rest_in = 0.1297;

double slope_in_per_volt(double volts) { return (3 * cubic * volts + 2 * quadratic) * volts + linear; }

} // namespace

double desired_spool_in(double volts) { return ((cubic * volts + quadratic) * volts + linear) * volts + rest_in; }

double servo_volts(double spool_in) {
    if (!(spool_in >= 0 && std::isfinite(spool_in)))
        throw std::invalid_argument(fmt::format("no voltage moves the spool to {} in, expected 0 or more", spool_in));
    // These bounds enclose the solution: above 0 V the function exceeds its linear part; at -.9245 V the function is
    // below 0.
    double least = spool_in < rest_in ? -0.9245 : 0, greatest = std::max((spool_in - rest_in) / linear, 0.0);
    auto excess = [=](double volts) { return std::pair(desired_spool_in(volts) - spool_in, slope_in_per_volt(volts)); };
    std::uintmax_t iterations = 100;
    return boost::math::tools::newton_raphson_iterate(excess, (least + greatest) / 2, least, greatest,
                                                      std::numeric_limits<double>::digits - 2, iterations);
}

double DriftedVoltageSpool::desired_spool_in(double volts_commanded, double time_s) const {
    return std::max(hydraulics::desired_spool_in(volts_commanded + volts.at(time_s)) + spool_in.at(time_s), 0.0);
}

SpoolLag::SpoolLag(double lag_per_s, double period_s, double spool_in)
    : kept_(std::exp(-lag_per_s * period_s)), spool_in_(spool_in) {
    if (!(lag_per_s > 0 && period_s > 0))
        throw std::invalid_argument(fmt::format(
            "the spool's lag is {} per s and its sampling period {} s, expected both above 0", lag_per_s, period_s));
}

std::vector<double> spool_from_volts(std::span<const double> volts, double lag_per_s, double period_s,
                                     const DriftedVoltageSpool& function) {
    std::vector<double> time_s;
    for (std::size_t k = 0; k < volts.size(); ++k)
        time_s.push_back(static_cast<double>(k) * period_s);
    return spool_from_volts(volts, time_s, lag_per_s, period_s, function);
}

std::vector<double> spool_from_volts(std::span<const double> volts, std::span<const double> time_s, double lag_per_s,
                                     double period_s, const DriftedVoltageSpool& function) {
    std::vector<double> spools;
    if (volts.empty())
        return spools;
    SpoolLag lag(lag_per_s, period_s, function.desired_spool_in(volts[0], time_s[0]));
    spools.reserve(volts.size());
    for (std::size_t k = 0; k < volts.size(); ++k) {
        if (k > 0)
            lag.hold(function.desired_spool_in(volts[k - 1], time_s[k - 1]),
                     std::round((time_s[k] - time_s[k - 1]) / period_s));
        spools.push_back(lag.spool_in());
    }
    return spools;
}

} // namespace placedpar::hydraulics
