#pragma once

#include "hydraulics/circuit/boom_orifices.hpp"
#include "hydraulics/circuit/cross_over.hpp"
#include "hydraulics/plant/dig_job.hpp"
#include "hydraulics/plant/moving_machine.hpp"

#include <functional>

namespace placedpar::hydraulics {

/// The true state of one link.
struct MovingLink {
    double inlet_psi, angle_rad, rate_rad_per_s, load_lbf;
    OrificeAreas areas;
    double inlet_in3_per_s; ///< from the main valve
};

struct MovingState {
    double time_s;
    PerLink<MovingLink> links;
    double p11_psi, p21_psi; ///< at the pumps
    BranchPressures branch;
    Configuration configuration; ///< by the true pressures
    TipPose asked;               ///< the reference trajectory
};

/// Simulates the job from rest and shows each state at the times of the controller. At these times the controller
/// reads angles, rates and inlet pressures, computes the rates that resolve the tip's reference into joints and
/// corrects them by proportional and derivative feedback. From the rates follow the flows, and from these by
/// feedforward.hpp the areas for the present configuration. The areas follow through the pilot valves' dead time and
/// lag.
///
/// Integrates by the Runge-Kutta method of order 4 in fixed steps. Each pump's line has the volume of its pipes, so
/// that flows are explicit; the cross-over valves move between steps. Throws UnfitScenario if the job leaves the arm's
/// reach or the soil lifts a load.
void simulate_moving(const MovingExcavator&, const DigJob&, const std::function<void(const MovingState&)>& show);

} // namespace placedpar::hydraulics
