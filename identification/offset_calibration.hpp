#pragma once

#include "hydraulics/circuit/circuit_sample.hpp"

#include <optional>
#include <span>

namespace placedpar::identification {

/// A stretch of motion in which pressure and velocity hardly change, so that the flow balance of equation 3.3
/// holds with C dP/dt near 0. All values ours.
struct SteadyMotion {
    double duration_s = 1;
    double drift_psi = 8;             ///< by which the mean pressures of its halves may differ
    double slope_psi_per_s = 250;     ///< greatest rms slope of the inlet pressure; noise alone stays below it
    double least_flow_in3_per_s = 10; ///< at every instant: the piston moves
};

/// A reading further off than this is of no use.
inline constexpr double greatest_spool_offset_in = 0.08;

struct SpoolOffset {
    double offset_in;    ///< by which the readings are too high
    double deviation_in; ///< standard error, from how the single samples scatter
    std::size_t samples;
};

/// The offset by the record's steadiest motion: what must be taken off the spool's readings so that on average the
/// pump's flow is what the cylinder takes up and what passes to the tank (equations 3.1 to 3.3 at dP/dt = 0). Of the
/// boom alone, its areas from the spool. None without a steady motion, or when no offset within 0.08 in
/// balances the flow.
/// It cannot tell an offset from a wrong k or Q: 1 % of either moves it by 0.0011 to 0.0016 in.
std::optional<SpoolOffset> calibrate_spool_offset(const hydraulics::Record& record,
                                                  const hydraulics::LinkCalibrations& calibrations,
                                                  const hydraulics::FlowConstants& flow,
                                                  const SteadyMotion& steady = {});

} // namespace placedpar::identification
