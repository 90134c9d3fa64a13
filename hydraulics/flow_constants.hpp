#pragma once

namespace placedpar {

/// What every orifice of the machine shares: flow = k a sqrt(pressure drop), a pump of constant flow, a tank.
/// Units throughout this room: inch, psi (gauge), lbf, s; the unit is in the name.
///
/// k, Q and P_e belong together: none is printed in the thesis, all three are fitted to its Table 2.6
/// ("Figure 2.6"), which fixes Q and a quarter of k to 0.3 % but lets P_e trade against k. So take a set, not
/// a value from each.
struct FlowConstants {
    double orifice_in3_per_s_in2_sqrt_psi; // k = Cd sqrt(2 / density)
    double pump_in3_per_s;                 // Q, one pump
    double tank_psi;                       // P_e, anything from 0 to 40 is possible
    double relief_psi = 4500;              // ours: needed since a_e is 0 beyond .376 in of spool
};

/// The best fit of Table 2.6: rms residual 0.61e-4 in of spool, the table's rounding.
inline constexpr FlowConstants fitted_flow_constants{99.83, 175.08, 16.2};
/// Round numbers that fit nearly as well: 0.67e-4 in.
inline constexpr FlowConstants rounded_flow_constants{100, 175, 25};

} // namespace placedpar
