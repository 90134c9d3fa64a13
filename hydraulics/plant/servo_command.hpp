#pragma once

#include "hydraulics/data/parameters.hpp"

#include <optional>

namespace placedpar::hydraulics {

/// The control system's command to the boom's servo-valve in a simulation. The voltage changes by a step or a ramp, and
/// optionally by a later step to a second voltage.
struct ServoCommand {
    double at_rest_volts;
    double step_time_s;
    double ramp_s; ///< 0: a step
    double desired_volts;
    std::optional<double> second_time_s;
    double second_volts;
};

/// Reads the parameters excavator.servo_*, excavator.step_time and excavator.second_time.
ServoCommand servo_command(const Parameters& parameters);

/// Returns the command at an instant, before a converter rounds it.
double volts_at(const ServoCommand& command, double time_s);

} // namespace placedpar::hydraulics
