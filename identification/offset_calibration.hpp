#pragma once

#include "hydraulics/circuit/circuit_sample.hpp"

#include <optional>
#include <span>

namespace placedpar::identification {

/// Criteria of steady motion, in which pressure and velocity hardly change, so that the flow balance of equation 3.3
/// holds with C dP/dt near 0. We chose all values.
struct SteadyMotion {
    double duration_s = 1;
    double drift_psi = 8;             ///< largest difference between the mean pressures of the motion's two halves
    double slope_psi_per_s = 250;     ///< greatest rms slope of the inlet pressure; noise alone stays below it
    double least_flow_in3_per_s = 10; ///< least flow at every instant, so that the piston moves
};

/// The greatest offset that can be corrected; a larger offset makes the readings useless.
inline constexpr double greatest_spool_offset_in = 0.08;

struct SpoolOffset {
    double offset_in;    ///< amount by which the readings are too high
    double deviation_in; ///< standard error, from the scatter of single samples
    std::size_t samples;
};

/// Finds the offset of the boom's spool from the record's steadiest motion. Subtracting the offset from the positions
/// makes the pump's mean flow equal to the cylinder's flow plus the flow to the tank (equations 3.1 to 3.3, without
/// dP/dt). The positions are computed from the servo-valve's voltage if `calibrations` states this source for the boom,
/// otherwise they are the readings of the spool. REQUIRES: the boom moves alone. Returns nullopt if
/// there is no steady motion, or if no offset within 0.08 in balances the flow. An error of 1 % in the orifice constant
/// k or the pump's flow Q shifts the result by 0.0011 to 0.0016 in.
std::optional<SpoolOffset> calibrate_spool_offset(const hydraulics::Record& record,
                                                  const hydraulics::LinkCalibrations& calibrations,
                                                  const hydraulics::FlowConstants& flow,
                                                  const SteadyMotion& steady = {});

} // namespace placedpar::identification
