#pragma once

#include <cstddef>
#include <span>

namespace placedpar::hydraulics {

/// What the error of identification needs of one link at one sampling instant.
struct LinkSample {
    double inlet_psi;             // P_i, the raw reading
    double inlet_slope_psi_per_s; // of the 5-point line
    double piston_flow_in3_per_s; // A_i times the piston velocity, of the 5-point line
    double inlet_in2;             // a_i; from the spool
    double bypass_in2;            // a_e

    /// As plain numbers, in the order above.
    static constexpr std::size_t channels = 5;
    /// REQUIRES: values.size() >= channels.
    static LinkSample from(std::span<const double> values) {
        return {values[0], values[1], values[2], values[3], values[4]};
    }
};

} // namespace placedpar::hydraulics
