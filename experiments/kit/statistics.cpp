#include "experiments/kit/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
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

} // namespace placedpar
