#include "hydraulics/data/frozen_run.hpp"

#include <cmath>

namespace placedpar::hydraulics {

std::optional<FrozenRun> frozen_run(std::span<const double> psi, std::size_t fewest, double least_jump_psi) {
    std::size_t first = 0;
    for (std::size_t i = 1; i + 1 < psi.size(); ++i) {
        if (psi[i] == psi[first])
            continue;
        double jump = psi[i] - psi[first], next = psi[i + 1] - psi[i];
        if (i - first >= fewest && std::abs(jump) >= least_jump_psi && std::abs(jump) > std::abs(next))
            return FrozenRun{first, i, jump};
        first = i;
    }
    return std::nullopt;
}

} // namespace placedpar::hydraulics
