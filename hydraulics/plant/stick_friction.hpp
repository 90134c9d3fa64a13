#pragma once

namespace placedpar::hydraulics {

/// Dry friction with stiction: the LuGre model (C. Canudas de Wit, H. Olsson, K. J. Astrom, P. Lischinsky, "A new model
/// for control of systems with friction", 1995), without its viscous part. Bristles hold the surfaces together. The
/// bristles bend like springs up to the break-away force, and slip at the Coulomb force. The model has known limits:
/// the body breaks away at a lower force if the force rises fast, and the body creeps under vibration.
struct StickFriction {
    double coulomb_lbf;
    double breakaway_lbf;                ///< >= coulomb_lbf
    double stribeck_in_per_s;            ///< velocity at which the force has mostly fallen to the Coulomb force
    double bristle_stiffness_lbf_per_in; ///< sigma_0
    double bristle_damping_lbf_s_per_in; ///< sigma_1; fades with velocity, so that the friction never adds energy
};

/// Returns the force of steady sliding: g(v) = F_c + (F_s - F_c) exp(-(v / v_s)^2).
double sliding_force_lbf(const StickFriction&, double velocity_in_per_s);

/// Returns the rate at which the bending z of the bristles changes: z' = v - sigma_0 |v| z / g(v).
double bristle_rate_in_per_s(const StickFriction&, double velocity_in_per_s, double bristle_in);

/// Returns the force against the motion: sigma_0 z + sigma_1 exp(-(v / v_s)^2) z'.
double friction_force_lbf(const StickFriction&, double velocity_in_per_s, double bristle_in);

} // namespace placedpar::hydraulics
