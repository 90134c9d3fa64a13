#pragma once

#include "experiments/chapter_3/kit/boom_data.hpp"

#include <vector>

namespace placedpar {

/// The cross-check of Figure 3.7: the inlet pressure P_i is simulated with a given compliance for a recorded motion,
/// and compared with the measured pressure.
struct PressureCheck {
    std::vector<double> time_s, measured_psi, simulated_psi;
    double from_s, until_s; ///< limits of the transient, which begins 0.02 s before the first usable sample and lasts
                            ///< 0.48 s
    double rms_psi;         ///< rms difference in the transient
    double rise_psi;        ///< rise of the measured pressure in the transient
    double peak_psi;        ///< peak of the simulated pressure in the transient
};

/// Simulates the pressure from the first sample at which the slopes of pressure and angle are known. The model says
/// where the spool position comes from, and which offset is subtracted from the position. The velocity is computed from
/// the measured angle. Throws UserError if the record has no usable sample. Also throws what replay_pressure() throws.
PressureCheck check_pressure(const BoomData&, const BoomModel&, double compliance_in3_per_psi);

} // namespace placedpar
