#pragma once

#include "hydraulics/data/parameters.hpp"
#include "hydraulics/plant/boom_sensors.hpp"

#include <vector>

namespace placedpar::hydraulics {

/// The control of the boom's angle by feedforward and P-D feedback (thesis 2.3.2). The demanded angle is at first
/// constant, and then rises at constant speed. Every sampling period the controller computes the flow for the desired
/// speed. It then computes the spool position that gives this flow at the pressure read, and the servo-valve's voltage
/// for this position.
struct BoomControl {
    double speed_deg_per_s;    ///< speed at which the demanded angle rises
    double step_time_s;        ///< time at which the demanded angle begins to rise
    double proportional_per_s; ///< K_p: the angle's error times K_p is added to the desired speed
    double velocity;           ///< K_v: the speed's error times K_v is added to the desired speed

    /// Returns the control without feedback, as in the thesis's recordings (3.1.2).
    BoomControl open_loop() const { return {speed_deg_per_s, step_time_s, 0, 0}; }
    /// Returns the demanded angle, relative to the angle at rest.
    double desired_deg(double time_s) const {
        return time_s > step_time_s ? speed_deg_per_s * (time_s - step_time_s) : 0;
    }
};

/// Reads the parameters boom_control.*, controller.asked_flow and excavator.step_time.
BoomControl boom_control(const Parameters& parameters = Parameters::excavator());

/// The true motion under control, and the readings from which the controller computed its voltages.
struct ControlledMotion {
    std::vector<MeasuredState> states;
    Record record;
};

/// Simulates the measured excavator (measured_excavator.hpp) under this control. The voltage stays in the range in
/// which it raises the boom. Until the demanded angle rises, the voltage is ServoCommand::at_rest_volts. Throws the
/// UnfitScenario (requirement.hpp) of simulate_measured_excavator().
ControlledMotion simulate_controlled(const MeasuredExcavator& excavator, const BoomSensors& sensors,
                                     const BoomControl& control, const UniformSource& uniform);

} // namespace placedpar::hydraulics
