#include "identification/on_line/cross_check.hpp"

#include "text/statistics.hpp"

#include <algorithm>

namespace placedpar::identification {

double LinkCheck::spread() const {
    if (estimates.size() < 2)
        return 0;
    std::vector<double> values;
    for (const SetEstimate& each : estimates)
        values.push_back(each.compliance_in3_per_psi);
    auto [least, greatest] = std::ranges::minmax(values);
    double middle = median(values);
    return middle > 0 ? (greatest - least) / middle : 1;
}

} // namespace placedpar::identification
