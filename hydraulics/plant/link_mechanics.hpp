#pragma once

#include "hydraulics/data/link.hpp"
#include "hydraulics/data/parameters.hpp"

namespace placedpar::hydraulics {

/// A link as a mass on a cylinder, or, for the swing, on a motor: area times moment arm is then its displacement per
/// radian. No value has a default: they come from excavator.csv, which says where each is from.
struct LinkMechanics {
    double inlet_area_in2;                ///< A_i, pump side of the piston
    double outlet_area_in2;               ///< A_o, drain side; 0: the drain side is left out of the simulation
    double moment_arm_in;                 ///< piston travel per radian of the joint
    double mass_lbf_s2_per_in;            ///< M, the link's inertia at the piston
    double damping_lbf_s_per_in;          ///< b
    double friction_lbf;                  ///< F_c, of friction F_c tanh(v / friction_velocity)
    double friction_velocity_in_per_s;    ///< > 0: the friction is smooth through rest
    double load_lbf;                      ///< F, what the piston holds
    double inlet_compliance_in3_per_psi;  ///< C_i
    double outlet_compliance_in3_per_psi; ///< C_o; of no effect without a drain side
    double spool_lag_per_s;               ///< a_0 of A.2

    /// By how much the joint has turned when the piston has moved so far.
    double joint_deg(double piston_in) const;
    /// The inlet pressure at which the load is held, or moves at a steady velocity; friction is left out.
    double steady_inlet_psi(double outlet_psi, double velocity_in_per_s = 0) const;
};

/// The boom of the single-link experiments, with its drain side, by the rows boom.*.
LinkMechanics single_boom_mechanics(const Parameters& parameters = Parameters::excavator());

/// One of several links that move (Figures 3.9 to 3.11): no drain side, damping in place of friction, as in appendix B.
LinkMechanics coupled_mechanics(Link link, const Parameters& parameters = Parameters::excavator());

} // namespace placedpar::hydraulics
