#pragma once

#include "hydraulics/circuit/boom_orifices.hpp"
#include "hydraulics/circuit/cross_over.hpp"
#include "hydraulics/plant/dig_job.hpp"
#include "hydraulics/plant/moving_machine.hpp"

#include <functional>

namespace placedpar::hydraulics {

/// The true state of one link of a digging excavator.
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
    TipPose asked;               ///< the pose that the controller demands from the arm
};

/// Simulates a digging job from rest. Once in every period of the controller, calls `show` with the state. At these
/// times the controller reads angles, rates and inlet pressures. The controller converts the demanded velocity of the
/// bucket's tip into joint rates, and corrects the rates by P-D feedback. From the rates it computes the flows. From
/// the flows it computes the areas for the present configuration (feedforward.hpp). Each command reaches the pilot
/// valves after their dead time, which may be longer than the controller's period. The valves then set the areas with a
/// lag.
///
/// Integrates by the Runge-Kutta method of order 4 in fixed steps. The oil in the pipes has a compliance at each
/// junction. The pressures are therefore states of the simulation, and the flows follow directly from them. The
/// cross-over valves move only between steps. Throws UnfitScenario if the job leaves the arm's reach, or if the
/// soil's force cancels a link's load.
void simulate_moving(const MovingExcavator&, const DigJob&, const std::function<void(const MovingState&)>& show);

} // namespace placedpar::hydraulics
