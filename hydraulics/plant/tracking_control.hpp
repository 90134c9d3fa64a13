#pragma once

#include "hydraulics/circuit/boom_orifices.hpp"
#include "hydraulics/plant/moving_machine.hpp"

namespace placedpar::hydraulics {

/// The readings of a link from which the controller of a digging excavator computes its demands.
struct TrackedLink {
    double inlet_psi, angle_rad, rate_rad_per_s;
};

/// Returns the areas that the controller of thesis 2.3.2 demands from the four valves. `angles` and `rates` are the
/// joints' angles and rates that the controller demands. A link with a demanded flow below
/// TrackingGains::least_flow_in3_per_s is held: its inlet and outlet are shut. A link gets at most the flow that
/// reaches its junction. Pressures stay below the relief pressure.
PerLink<OrificeAreas> asked_areas(const MovingExcavator&, Configuration, const PerLink<TrackedLink>&,
                                  const JointAngles& angles, const JointAngles& rates);

} // namespace placedpar::hydraulics
