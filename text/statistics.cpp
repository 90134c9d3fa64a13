#include "text/statistics.hpp"

#include <boost/math/statistics/univariate_statistics.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>

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

double median(std::vector<double> values) { return boost::math::statistics::median(values); }

double lower_median(std::vector<double> values) { return quantile(std::move(values), 0.5); }

double quantile(std::vector<double> values, double share) {
    auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(values.size())));
    auto place = values.begin() + static_cast<std::ptrdiff_t>(std::max<std::size_t>(rank, 1) - 1);
    std::ranges::nth_element(values, place);
    return *place;
}

} // namespace placedpar
