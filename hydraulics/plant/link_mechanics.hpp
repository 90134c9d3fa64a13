#pragma once

#include "hydraulics/data/link.hpp"
#include "hydraulics/data/parameters.hpp"

namespace placedpar::hydraulics {

/// A link of the excavator, modelled as a mass on a cylinder. The swing has a motor instead; its displacement per
/// radian is area times moment arm. All values come from excavator.csv, which states the source of each.
struct LinkMechanics {
    double inlet_area_in2;                ///< A_i, pump side of the piston
    double outlet_area_in2;               ///< A_o, drain side of the piston; 0: the drain side is not simulated
    double moment_arm_in;                 ///< piston travel per radian of the joint
    double mass_lbf_s2_per_in;            ///< M, the link's inertia at the piston
    double damping_lbf_s_per_in;          ///< b
    double friction_lbf;                  ///< F_c; the friction is F_c tanh(v / friction_velocity)
    double friction_velocity_in_per_s;    ///< > 0, so that the friction is smooth at rest
    double load_lbf;                      ///< F, the load on the piston
    double inlet_compliance_in3_per_psi;  ///< C_i
    double outlet_compliance_in3_per_psi; ///< C_o; ignored without a drain side
    double spool_lag_per_s;               ///< a_0 of A.2, the lag of the spool behind its command

    /// Returns the angle by which the joint turns when the piston moves by `piston_in`.
    double joint_deg(double piston_in) const;
    /// Returns the inlet pressure at which the load moves at a steady velocity, or is held if the velocity is 0. Dry
    /// friction is left out.
    double steady_inlet_psi(double outlet_psi, double velocity_in_per_s = 0) const;
};

/// Returns the boom of the experiments in which only the boom moves, with its drain side, from the parameters boom.*.
LinkMechanics single_boom_mechanics(const Parameters& parameters = Parameters::excavator());

/// Returns a link of the experiments with several moving links (Figures 3.9 to 3.11). As in appendix B of the thesis,
/// the drain side is left out, and damping replaces dry friction.
LinkMechanics coupled_mechanics(Link link, const Parameters& parameters = Parameters::excavator());

} // namespace placedpar::hydraulics
