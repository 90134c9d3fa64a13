#pragma once

#include "hydraulics/data/parameters.hpp"

#include <optional>

namespace placedpar::hydraulics {

/// What the control system asks of the boom's servo-valve: a voltage, reached by a ramp or at once, and later perhaps
/// another.
struct ServoCommand {
    double at_rest_volts;
    double step_time_s;
    double ramp_s; ///< 0: at once
    double desired_volts;
    std::optional<double> second_time_s;
    double second_volts;
};

/// By the rows excavator.servo_*, excavator.step_time and excavator.second_time.
ServoCommand servo_command(const Parameters& parameters);

/// The command at an instant, before any converter.
double volts_at(const ServoCommand& command, double time_s);

} // namespace placedpar::hydraulics
