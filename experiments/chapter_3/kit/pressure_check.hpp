#pragma once

#include "experiments/chapter_3/kit/boom_data.hpp"

#include <vector>

namespace placedpar {

/// The cross-check of Figure 3.7: the pressure P_i that a compliance would have given to a recorded motion.
struct PressureCheck {
    std::vector<double> time_s, measured_psi, simulated_psi;
    double from_s, until_s; ///< the transient: from just before the inlet opens, for 0.48 s
    double rms_psi;         ///< of the difference over the transient
    double rise_psi;        ///< of the measured pressure over it
    double peak_psi;        ///< of the simulated pressure over it
};

/// Simulates from the record's first slope on, spool and offset by the model, velocity from the angle. Throws
/// UserError when the inlet never opens, and as replay_pressure().
PressureCheck check_pressure(const BoomData&, const BoomModel&, double compliance_in3_per_psi);

} // namespace placedpar
