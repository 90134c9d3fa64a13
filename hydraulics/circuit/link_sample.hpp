#pragma once

#include "hydraulics/circuit/orifice.hpp"

#include <cstddef>
#include <span>

namespace placedpar::hydraulics {

/// The values of one link at one instant, from which identification computes the error of a trial compliance. For the
/// outlet side of a cylinder the members have other meanings. The pressure is P_o, the piston's flow is -A_o times the
/// velocity, and bypass_in2 is the outlet's area a_o. inlet_in2 is infinite, since the sensor reads the pressure at the
/// junction itself. The imbalance of flow is then the error of equation 3.4.
struct LinkSample {
    double inlet_psi;             ///< P_i, without smoothing
    double inlet_slope_psi_per_s; ///< slope of the line fitted to 5 readings
    double piston_flow_in3_per_s; ///< A_i times the piston's velocity, the slope of the line fitted to 5 readings
    double inlet_in2;             ///< a_i
    double bypass_in2;            ///< a_e

    /// The number of values. A list of values has the order of the members above.
    static constexpr std::size_t channels = 5;
    /// REQUIRES: values.size() >= channels.
    static LinkSample from(std::span<const double> values) {
        return {values[0], values[1], values[2], values[3], values[4]};
    }

    friend bool operator==(const LinkSample&, const LinkSample&) = default;
};

/// These functions give the flows and pressures that follow from a trial compliance of one link. They hold in any
/// consistent system of units. T is double, or a class of several doubles. `conductance` is the flow through an orifice
/// divided by the root of the pressure drop.

/// Returns the flow into the cylinder (3.5, B.2). This flow moves the piston and expands the hose and oil of the pump
/// side.
template <typename T>
T cylinder_flow(double piston_flow, double pressure_slope, const T& compliance) {
    return piston_flow + pressure_slope * compliance;
}

/// Returns the pressure at the junction that drives this flow into the link (3.6, B.3).
template <typename T>
T junction_pressure(double inlet_conductance, double link_pressure, const T& flow) {
    return orifice_drop(inlet_conductance, flow) + link_pressure;
}

/// Returns the flow from a junction through the bypass (3.7, B.3). `drop` is the pressure drop to the tank or to the
/// next junction.
template <typename T>
T bypass_flow(double bypass_conductance, const T& drop) {
    return orifice_flow(bypass_conductance, drop);
}

} // namespace placedpar::hydraulics
