#pragma once

#include "hydraulics/circuit/cross_over.hpp"
#include "hydraulics/plant/link_mechanics.hpp"
#include "hydraulics/plant/tip_kinematics.hpp"

namespace placedpar::hydraulics {

/// The gains of the controller (thesis 2.3.2), and the pressure drops across the orifices that its feedforward assumes.
struct TrackingGains {
    double proportional_per_s;   ///< gain of the angle's error
    double derivative;           ///< gain of the rate's error
    double least_flow_in3_per_s; ///< a link with a smaller demanded flow is held
    double inlet_drop_psi, bypass_drop_psi;
};

/// An excavator whose four links dig: the simplified links and valves of appendix B, the whole main valve with its
/// cross-over network, and the controller that follows the joysticks.
///
/// A link moves backwards under its load, without the pump, and the valve throttles the oil that flows to the tank.
/// This model is ours: the thesis gives no equations for backward motion.
struct MovingExcavator {
    MainValve valve{};
    CrossOverLimits cross_over{};
    PerLink<LinkMechanics> links{};
    ArmLengths arm{};
    TrackingGains gains{};
    double joystick_lag_s = 0;
    double bypass_rest_in2 = 0;  ///< bypass area of a valve at rest
    double dead_time_s = 0;      ///< dead time of the pilot valves; their lag is LinkMechanics::spool_lag_per_s
    double control_period_s = 0; ///< also the interval between the states that are shown
    double integration_step_s = 0;
};

/// Reads the parameters that digging_uses() names (record_scenario.hpp).
MovingExcavator moving_excavator(const Parameters& parameters);

} // namespace placedpar::hydraulics
