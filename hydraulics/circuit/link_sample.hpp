#pragma once

#include "hydraulics/circuit/orifice.hpp"

#include <cstddef>
#include <span>

namespace placedpar::hydraulics {

/// What the error of identification needs of one link at one sampling instant.
struct LinkSample {
    double inlet_psi;             ///< P_i, the raw reading
    double inlet_slope_psi_per_s; ///< of the 5-point line
    double piston_flow_in3_per_s; ///< A_i times the piston velocity, of the 5-point line
    double inlet_in2;             ///< a_i; from the spool
    double bypass_in2;            ///< a_e

    /// As plain numbers, in the order above.
    static constexpr std::size_t channels = 5;
    /// REQUIRES: values.size() >= channels.
    static LinkSample from(std::span<const double> values) {
        return {values[0], values[1], values[2], values[3], values[4]};
    }

    friend bool operator==(const LinkSample&, const LinkSample&) = default;
};

/// The equations by which a supposed compliance is judged, one link at a time. Units may be of any consistent system;
/// T is as in orifice.hpp, and `conductance` is k a of the inlet or the bypass.

/// 3.5, B.2: the flow into the cylinder moves the piston and swells the pump side.
template <typename T>
T cylinder_flow(double piston_flow, double pressure_slope, const T& compliance) {
    return piston_flow + pressure_slope * compliance;
}

/// 3.6, B.3: the pressure at the junction that drives this flow into the link.
template <typename T>
T junction_pressure(double inlet_conductance, double link_pressure, const T& flow) {
    return orifice_drop(inlet_conductance, flow) + link_pressure;
}

/// 3.7, B.3: what leaves a junction through the bypass. `drop` is to the tank or to the next junction.
template <typename T>
T bypass_flow(double bypass_conductance, const T& drop) {
    return orifice_flow(bypass_conductance, drop);
}

} // namespace placedpar::hydraulics
