#pragma once

namespace placedpar::hydraulics {

class Parameters; // hydraulics/data/parameters.hpp

/// What every orifice of the excavator shares: flow = k a sqrt(pressure drop), a pump of constant flow, a tank.
/// Units throughout this room: inch, psi (gauge), lbf, s; the unit is in the name.
///
/// k, Q and P_e belong together (excavator.csv): take a set, not a value from each.
struct FlowConstants {
    double orifice_in3_per_s_in2_sqrt_psi; ///< k = Cd sqrt(2 / density)
    double pump_in3_per_s;                 ///< Q, one pump
    double tank_psi;                       ///< P_e, anything from 0 to 40 is possible
    double relief_psi;                     ///< at which a pump's relief valve opens

    /// k a of an orifice, in^3/s per root psi.
    double conductance(double area_in2) const { return orifice_in3_per_s_in2_sqrt_psi * area_in2; }
    friend bool operator==(const FlowConstants&, const FlowConstants&) = default;
};

/// By the rows flow.orifice, flow.pump, flow.tank and flow.relief.
FlowConstants flow_constants(const Parameters& parameters);
/// Returns those of Parameters::excavator().
FlowConstants flow_constants();

/// The excavator's own, the best fit of Table 2.6: rms residual 0.61e-4 in of spool, the table's rounding.
const FlowConstants& fitted_flow_constants();
/// Round numbers that fit nearly as well: 0.67e-4 in. The relief pressure is the excavator's.
const FlowConstants& rounded_flow_constants();

} // namespace placedpar::hydraulics
