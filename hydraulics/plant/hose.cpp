#include "hydraulics/plant/hose.hpp"

#include <cmath>

namespace placedpar::hydraulics {

double natural_rad_per_s(const Hose& hose, const HoseEnds& ends) {
    return std::sqrt((1 / ends.valve_in3_per_psi + 1 / ends.cylinder_in3_per_psi) / hose.inertance_psi_s2_per_in3);
}

} // namespace placedpar::hydraulics
