#pragma once

#include "hydraulics/circuit/circuit_sample.hpp"

#include <optional>
#include <span>

namespace placedpar::identification {

/// Criteria of steady motion, in which pressure and velocity hardly change. No oil then flows into the compliance, so
/// an imbalance of flow shows an offset of the spool. All values are this project's choice.
struct SteadyMotion {
    double duration_s = 1;
    /// The largest accepted difference between the mean pressures of the motion's first and second half.
    double drift_psi = 8;
    double slope_psi_per_s = 250;     ///< greatest accepted rms slope of the inlet pressure; noise alone causes less
    double least_flow_in3_per_s = 10; ///< least flow into the cylinder at every instant, so that the piston moves
};

/// The greatest offset that can be corrected. With a larger offset the readings are useless.
inline constexpr double greatest_spool_offset_in = 0.08;

struct SpoolOffset {
    double offset_in;    ///< amount by which the readings are too high
    double deviation_in; ///< standard error, from the scatter of single samples
    std::size_t samples;
};

/// Finds the offset of the boom's spool from the record's steadiest motion. With the offset subtracted, the pump's mean
/// flow equals the cylinder's flow plus the flow to the tank (equations 3.1 to 3.3, without dP/dt). The spool's
/// positions are its readings. If `calibrations` states AreasFrom::servo for the boom, the positions are computed from
/// the servo-valve's voltage. REQUIRES: the boom moves alone. Returns nullopt if the record has no steady motion, or if
/// no offset within 0.08 in balances the flow. An error of 1 % in the orifice constant k or the pump's flow Q shifts
/// the result by 0.0011 to 0.0016 in.
std::optional<SpoolOffset> calibrate_spool_offset(const hydraulics::Record& record,
                                                  const hydraulics::LinkCalibrations& calibrations,
                                                  const hydraulics::FlowConstants& flow,
                                                  const SteadyMotion& steady = {});

} // namespace placedpar::identification
