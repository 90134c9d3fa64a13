#include "text/statistics.hpp"

#include <boost/math/statistics/univariate_statistics.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace placedpar {

double median(std::vector<double> values) { return boost::math::statistics::median(values); }

double lower_median(std::vector<double> values) { return quantile(std::move(values), 0.5); }

double quantile(std::vector<double> values, double share) {
    auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(values.size())));
    auto place = values.begin() + static_cast<std::ptrdiff_t>(std::max<std::size_t>(rank, 1) - 1);
    std::ranges::nth_element(values, place);
    return *place;
}

} // namespace placedpar
