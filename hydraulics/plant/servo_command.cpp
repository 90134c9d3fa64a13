#include "hydraulics/plant/servo_command.hpp"

#include <algorithm>

namespace placedpar::hydraulics {

ServoCommand servo_command(const Parameters& parameters) {
    ServoCommand command{.at_rest_volts = parameters["excavator.servo_at_rest"],
                         .step_time_s = parameters["excavator.step_time"],
                         .ramp_s = parameters["excavator.servo_ramp"],
                         .desired_volts = parameters["excavator.servo_desired"],
                         .second_time_s = {},
                         .second_volts = parameters["excavator.servo_second"]};
    if (double second = parameters["excavator.second_time"]; second > 0)
        command.second_time_s = second;
    return command;
}

double volts_at(const ServoCommand& command, double time_s) {
    if (time_s < command.step_time_s)
        return command.at_rest_volts;
    if (command.second_time_s && time_s >= *command.second_time_s)
        return command.second_volts;
    if (command.ramp_s <= 0)
        return command.desired_volts;
    double gone = std::min((time_s - command.step_time_s) / command.ramp_s, 1.0);
    return command.at_rest_volts + gone * (command.desired_volts - command.at_rest_volts);
}

} // namespace placedpar::hydraulics
