#pragma once

#include "hydraulics/circuit/boom_orifices.hpp"
#include "hydraulics/plant/moving_machine.hpp"

namespace placedpar::hydraulics {

/// The controller's readings of a link.
struct TrackedLink {
    double inlet_psi, angle_rad, rate_rad_per_s;
};

/// Returns the areas that the controller of 2.3.2 demands from the four valves. `angles` and `rates` are the reference
/// trajectory. A link with a demanded flow below TrackingGains::least_flow_in3_per_s is held: its inlet and outlet are
/// shut. The controller asks for at most the flow that reaches a junction, and for pressures below the relief pressure.
PerLink<OrificeAreas> asked_areas(const MovingExcavator&, Configuration, const PerLink<TrackedLink>&,
                                  const JointAngles& angles, const JointAngles& rates);

} // namespace placedpar::hydraulics
