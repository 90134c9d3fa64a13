#pragma once

namespace placedpar::hydraulics {

/// A second-order model of a hose, for a simulation more exact than the thesis's. The fluid moves as one mass between
/// two compliances, at the valve's end and at the cylinder's end. The thesis's first-order model has no mass, and only
/// the sum of the two compliances.
struct Hose {
    double inertance_psi_s2_per_in3; ///< I = density length / bore
    double resistance_psi_s_per_in3; ///< R, laminar
    double valve_share;              ///< share of the compliance at the valve's end
};

/// The compliances at the two ends.
struct HoseEnds {
    double valve_in3_per_psi, cylinder_in3_per_psi;
};

/// Divides the compliance between the two ends. REQUIRES: 0 < valve_share < 1, compliance > 0.
inline HoseEnds ends_of(const Hose& hose, double compliance_in3_per_psi) {
    double valve = hose.valve_share * compliance_in3_per_psi;
    return {valve, compliance_in3_per_psi - valve};
}

/// The state of the fluid in a hose, or the rates at which this state changes. Flow is positive from the first end to
/// the second.
struct HoseLine {
    double first_psi, flow_in3_per_s, second_psi;
};

/// Returns the rates for a hose whose ends have the compliances `first_in3_per_psi` and `second_in3_per_psi`. The flow
/// `fed_in3_per_s` enters at the first end, and the flow `drawn_in3_per_s` leaves at the second.
inline HoseLine rates_of(const Hose& hose, double first_in3_per_psi, double second_in3_per_psi, const HoseLine& line,
                         double fed_in3_per_s, double drawn_in3_per_s) {
    return {(fed_in3_per_s - line.flow_in3_per_s) / first_in3_per_psi,
            (line.first_psi - line.second_psi - hose.resistance_psi_s_per_in3 * line.flow_in3_per_s) /
                hose.inertance_psi_s2_per_in3,
            (line.flow_in3_per_s - drawn_in3_per_s) / second_in3_per_psi};
}

/// Returns the undamped natural frequency of the fluid in a hose with both ends shut: sqrt((1/C_1 + 1/C_2) / I). A
/// simulation's step must be short compared with its period.
double natural_rad_per_s(const Hose& hose, const HoseEnds& ends);

} // namespace placedpar::hydraulics
