#pragma once

namespace placedpar::hydraulics {

class Parameters; // hydraulics/data/parameters.hpp

/// The constants that all orifices of the excavator share. The flow through an orifice of area a is k a sqrt(pressure
/// drop). Each pump has a constant flow. The units in hydraulics/ are inch, psi (gauge), lbf and s, and each name
/// includes its unit.
///
/// k, Q and P_e were fitted together (excavator.csv). Use all three from one set, because values from different sets do
/// not fit each other.
struct FlowConstants {
    double orifice_in3_per_s_in2_sqrt_psi; ///< k = Cd sqrt(2 / density)
    double pump_in3_per_s;                 ///< Q, the flow of one pump
    double tank_psi;                       ///< P_e; Table 2.6 allows any value from 0 to 40
    double relief_psi;                     ///< pressure at which a pump's relief valve opens

    /// Returns k a of an orifice, in in^3/s per sqrt(psi).
    double conductance(double area_in2) const { return orifice_in3_per_s_in2_sqrt_psi * area_in2; }
    friend bool operator==(const FlowConstants&, const FlowConstants&) = default;
};

/// Reads the parameters flow.orifice, flow.pump, flow.tank and flow.relief.
FlowConstants flow_constants(const Parameters& parameters);
/// Returns the constants of the excavator that is part of the program.
FlowConstants flow_constants();

/// Returns the constants of the best fit to Table 2.6 of the thesis, which lists spool positions for steady flows. The
/// rms residual is 0.61e-4 in of spool position, about the rounding error of the table.
const FlowConstants& fitted_flow_constants();
/// Returns round numbers that fit Table 2.6 nearly as well: the rms residual is 0.67e-4 in. The relief pressure is the
/// same as in fitted_flow_constants().
const FlowConstants& rounded_flow_constants();

} // namespace placedpar::hydraulics
