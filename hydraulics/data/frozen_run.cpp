#include "hydraulics/data/frozen_run.hpp"

#include <algorithm>
#include <cmath>

namespace placedpar::hydraulics {

std::size_t fewest_frozen(double period_s) {
    constexpr double frozen_for_s = 0.1;
    return std::max<std::size_t>(5, static_cast<std::size_t>(std::lround(frozen_for_s / period_s)));
}

std::optional<FrozenRun> frozen_run(std::span<const double> readings, double least_jump, std::size_t fewest) {
    std::size_t first = 0;
    for (std::size_t i = 1; i + 1 < readings.size(); ++i) {
        if (readings[i] == readings[first])
            continue;
        double jump = readings[i] - readings[first], next = readings[i + 1] - readings[i];
        if (i - first >= fewest && std::abs(jump) >= least_jump && std::abs(jump) > std::abs(next))
            return FrozenRun{first, i, jump};
        first = i;
    }
    return std::nullopt;
}

} // namespace placedpar::hydraulics
