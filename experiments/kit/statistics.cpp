#include "experiments/kit/statistics.hpp"

#include "identification/statistics.hpp"
#include "runtime/random.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>

namespace placedpar {

double mean(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double deviation(const std::vector<double>& values) {
    double centre = mean(values), squares = 0;
    for (double value : values)
        squares += (value - centre) * (value - centre);
    return std::sqrt(squares / static_cast<double>(values.size() - 1));
}

double percent_within(const std::vector<double>& values, double limit) {
    auto within = std::ranges::count_if(values, [&](double value) { return value <= limit; });
    return 100 * static_cast<double>(within) / static_cast<double>(values.size());
}

Interval median_interval(const std::vector<double>& values) {
    constexpr std::size_t samples = 2000;
    RandomStream random(1, "bootstrap");
    std::vector<double> medians, sample(values.size());
    for (std::size_t i = 0; i < samples; ++i) {
        for (double& each : sample)
            each = values[random.below(static_cast<std::uint32_t>(values.size()))];
        medians.push_back(identification::median(sample));
    }
    return {identification::median(values), identification::quantile(medians, 0.025),
            identification::quantile(medians, 0.975)};
}

} // namespace placedpar
