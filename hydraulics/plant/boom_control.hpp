#pragma once

#include "hydraulics/data/parameters.hpp"
#include "hydraulics/plant/boom_sensors.hpp"

#include <vector>

namespace placedpar::hydraulics {

/// The control of the boom's angle by feedforward and P-D feedback (2.3.2). The reference stays at rest, and then rises
/// at constant speed. Every sampling period the control computes in turn the flow for a desired speed, the spool
/// position for this flow at the pressure read (boom_spool_for_flow()), and the voltage for this position by the
/// inverse of A.1.
struct BoomControl {
    double speed_deg_per_s;    ///< speed at which the reference rises
    double step_time_s;        ///< time at which the reference begins to rise
    double proportional_per_s; ///< K_p: the angle's error times K_p is added to the desired speed
    double velocity;           ///< K_v: the speed's error times K_v is added to the desired speed

    /// Returns the feedforward without feedback, the open loop of the thesis's recordings (3.1.2).
    BoomControl open_loop() const { return {speed_deg_per_s, step_time_s, 0, 0}; }
    /// Returns the reference, relative to the angle at rest.
    double desired_deg(double time_s) const {
        return time_s > step_time_s ? speed_deg_per_s * (time_s - step_time_s) : 0;
    }
};

/// Reads the rows boom_control.*, controller.asked_flow and excavator.step_time.
BoomControl boom_control(const Parameters& parameters = Parameters::excavator());

/// The true motion under control, and the readings on which the control acted.
struct ControlledMotion {
    std::vector<MeasuredState> states;
    Record record;
};

/// Simulates the measured excavator under this control. The voltage stays in the range in which A.1 raises the boom.
/// Until the reference rises, the voltage is ServoCommand::at_rest_volts. Throws the UnfitScenario (requirement.hpp) of
/// simulate_measured_excavator().
ControlledMotion simulate_controlled(const MeasuredExcavator& excavator, const BoomSensors& sensors,
                                     const BoomControl& control, const UniformSource& uniform);

} // namespace placedpar::hydraulics
