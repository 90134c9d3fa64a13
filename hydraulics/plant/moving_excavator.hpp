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
    double inlet_in3_per_s; ///< flow from the main valve
};

struct MovingState {
    double time_s;
    PerLink<MovingLink> links;
    double p11_psi, p21_psi; ///< pressures at the pumps
    BranchPressures branch;
    Configuration configuration; ///< the configuration that the true pressures cause
    TipPose asked;               ///< the reference trajectory
};

/// Simulates the job from rest, and calls `show` with the state at each time of the controller. At these times the
/// controller reads angles, rates and inlet pressures. The controller resolves the velocity of the tip's reference into
/// joint rates, and corrects the rates by P-D feedback. It computes the flows from the rates, and the areas for the
/// present configuration from the flows (feedforward.hpp). Each command reaches the pilot valves after their dead time,
/// which may be longer than the controller's period. The valves then set the areas with a lag.
///
/// Integrates by the Runge-Kutta method of order 4 in fixed steps. Each junction has the compliance of the oil in its
/// pipes, so that flows follow directly from the pressures. The cross-over valves move between steps. Throws
/// UnfitScenario if the job leaves the arm's reach, or if the soil's force cancels a link's load.
void simulate_moving(const MovingExcavator&, const DigJob&, const std::function<void(const MovingState&)>& show);

} // namespace placedpar::hydraulics
