#include "hydraulics/plant/stick_friction.hpp"

#include <cmath>

namespace placedpar::hydraulics {

namespace {

/// Returns a factor that is 1 at rest and falls towards 0 with velocity.
double sticking(const StickFriction& friction, double velocity_in_per_s) {
    double ratio = velocity_in_per_s / friction.stribeck_in_per_s;
    return std::exp(-ratio * ratio);
}

} // namespace

double sliding_force_lbf(const StickFriction& friction, double velocity_in_per_s) {
    return friction.coulomb_lbf +
           (friction.breakaway_lbf - friction.coulomb_lbf) * sticking(friction, velocity_in_per_s);
}

double bristle_rate_in_per_s(const StickFriction& friction, double velocity_in_per_s, double bristle_in) {
    double force = sliding_force_lbf(friction, velocity_in_per_s);
    if (force == 0)
        return 0;
    return velocity_in_per_s - friction.bristle_stiffness_lbf_per_in * std::abs(velocity_in_per_s) * bristle_in / force;
}

double friction_force_lbf(const StickFriction& friction, double velocity_in_per_s, double bristle_in) {
    if (friction.breakaway_lbf == 0)
        return 0;
    double damping = friction.bristle_damping_lbf_s_per_in * sticking(friction, velocity_in_per_s);
    return friction.bristle_stiffness_lbf_per_in * bristle_in +
           damping * bristle_rate_in_per_s(friction, velocity_in_per_s, bristle_in);
}

} // namespace placedpar::hydraulics
