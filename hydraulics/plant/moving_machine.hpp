#pragma once

#include "hydraulics/circuit/cross_over.hpp"
#include "hydraulics/plant/link_mechanics.hpp"
#include "hydraulics/plant/tip_kinematics.hpp"

namespace placedpar::hydraulics {

/// The gains of the controller (thesis 2.3.2), and the pressure drops over the orifices for which the controller
/// computes their areas.
struct TrackingGains {
    double proportional_per_s;   ///< gain of the angle's error
    double derivative;           ///< gain of the rate's error
    double least_flow_in3_per_s; ///< a link with a smaller demanded flow is held
    double inlet_drop_psi, bypass_drop_psi;
};

/// An excavator whose four links dig, for the simulation of moving_excavator.hpp. Links and valves are the simplified
/// ones of the thesis's appendix B. The main valve is complete: its cross-over network leads one pump's surplus oil to
/// the other pump's links. A controller follows the joysticks.
///
/// The load, and not the pump, moves a link backwards, while the valve throttles the oil that flows to the tank. The
/// thesis has no equations for backward motion, so this model is this project's.
struct MovingExcavator {
    MainValve valve{};
    CrossOverLimits cross_over{};
    PerLink<LinkMechanics> links{};
    ArmLengths arm{};
    TrackingGains gains{};
    double joystick_lag_s = 0;
    double bypass_rest_in2 = 0;  ///< bypass area of a valve at rest
    double dead_time_s = 0;      ///< dead time of the pilot valves; their lag is LinkMechanics::spool_lag_per_s
    double control_period_s = 0; ///< also the interval between the states that simulate_moving() shows
    double integration_step_s = 0;
};

/// Reads the parameters that digging_scenario() uses (record_scenario.hpp).
MovingExcavator moving_excavator(const Parameters& parameters);

} // namespace placedpar::hydraulics
