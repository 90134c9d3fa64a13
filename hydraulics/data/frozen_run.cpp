#include "hydraulics/data/frozen_run.hpp"

#include <cmath>

namespace placedpar::hydraulics {

std::optional<FrozenRun> frozen_run(std::span<const double> readings, double least_jump) {
    std::size_t first = 0;
    for (std::size_t i = 1; i + 1 < readings.size(); ++i) {
        if (readings[i] == readings[first])
            continue;
        double jump = readings[i] - readings[first], next = readings[i + 1] - readings[i];
        if (i - first >= fewest_frozen && std::abs(jump) >= least_jump && std::abs(jump) > std::abs(next))
            return FrozenRun{first, i, jump};
        first = i;
    }
    return std::nullopt;
}

} // namespace placedpar::hydraulics
