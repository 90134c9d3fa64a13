#include "hydraulics/circuit/leakage.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <stdexcept>

namespace placedpar::hydraulics {

double apparent_compliance_change(std::span<const double> leak_in3_per_s, std::span<const double> slope_psi_per_s) {
    if (leak_in3_per_s.size() != slope_psi_per_s.size())
        throw std::invalid_argument(
            fmt::format("{} leak flows and {} pressure slopes were given, expected equal numbers",
                        leak_in3_per_s.size(), slope_psi_per_s.size()));
    double products = 0, squares = 0;
    for (std::size_t i = 0; i < slope_psi_per_s.size(); ++i) {
        products += leak_in3_per_s[i] * slope_psi_per_s[i];
        squares += slope_psi_per_s[i] * slope_psi_per_s[i];
    }
    if (!(squares > 0))
        throw std::invalid_argument("every pressure slope is 0, expected at least one other slope");
    return products / squares;
}

} // namespace placedpar::hydraulics
