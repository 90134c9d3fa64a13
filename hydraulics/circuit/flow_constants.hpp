#pragma once

#include "hydraulics/data/parameters.hpp"

namespace placedpar::hydraulics {

/// What every orifice of the machine shares: flow = k a sqrt(pressure drop), a pump of constant flow, a tank.
/// Units throughout this room: inch, psi (gauge), lbf, s; the unit is in the name.
///
/// k, Q and P_e belong together (excavator.csv): take a set, not a value from each.
struct FlowConstants {
    double orifice_in3_per_s_in2_sqrt_psi; // k = Cd sqrt(2 / density)
    double pump_in3_per_s;                 // Q, one pump
    double tank_psi;                       // P_e, anything from 0 to 40 is possible
    double relief_psi = Parameters::excavator()["flow.relief"];
};

/// The machine's own.
inline FlowConstants flow_constants(const Parameters& machine = Parameters::excavator()) {
    return {machine["flow.orifice"], machine["flow.pump"], machine["flow.tank"], machine["flow.relief"]};
}

/// The best fit of Table 2.6: rms residual 0.61e-4 in of spool, the table's rounding.
inline const FlowConstants fitted_flow_constants = flow_constants();
/// Round numbers that fit nearly as well: 0.67e-4 in.
inline const FlowConstants rounded_flow_constants{Parameters::excavator()["flow.rounded.orifice"],
                                                  Parameters::excavator()["flow.rounded.pump"],
                                                  Parameters::excavator()["flow.rounded.tank"]};

} // namespace placedpar::hydraulics
