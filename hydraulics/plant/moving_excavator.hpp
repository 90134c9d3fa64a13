#pragma once

#include "hydraulics/circuit/boom_orifices.hpp"
#include "hydraulics/circuit/cross_over.hpp"
#include "hydraulics/circuit/flow_constants.hpp"
#include "hydraulics/plant/dig_job.hpp"
#include "hydraulics/plant/link_mechanics.hpp"

#include <functional>

namespace placedpar::hydraulics {

/// The gains of the controller of 2.3.2 and what its feedforward leaves over the orifices.
struct TrackingGains {
    double proportional_per_s;   ///< of an error in angle
    double derivative;           ///< of an error in rate
    double least_flow_in3_per_s; ///< below it, a link is held
    double inlet_drop_psi, bypass_drop_psi;
};

/// An excavator whose four links dig: the simplified links and valves of appendix B, the whole main valve with its
/// cross-over network, and the controller that follows the joysticks.
///
/// A link that goes back is not pumped: its load drives it, and the valve throttles its oil to the tank (ours; the
/// thesis gives no equations for that direction).
struct MovingExcavator {
    FlowConstants flow{};
    CrossOverLimits cross_over{};
    PerLink<LinkMechanics> links{};
    ArmLengths arm{};
    TrackingGains gains{};
    double joystick_lag_s = 0;
    double bypass_rest_in2 = 0;               ///< of a valve at rest
    double dead_time_s = 0;                   ///< of the pilot valves; their lag is LinkMechanics::spool_lag_per_s
    double branch_compliance_in3_per_psi = 0; ///< of the oil in a pump's line and valve: volume / bulk modulus
    double laminar_psi = 0;                   ///< drop below which flow is proportional to it
    double control_period_s = 0;              ///< also the interval between the states that are shown
    double integration_step_s = 0;
};

/// Reads the rows that digging_uses() lists (record_scenario.hpp).
MovingExcavator moving_excavator(const Parameters& parameters);

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
