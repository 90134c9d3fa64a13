#include "hydraulics/plant/moving_machine.hpp"

#include "hydraulics/data/parameters.hpp"

namespace placedpar::hydraulics {

MovingExcavator moving_excavator(const Parameters& parameters) {
    MovingExcavator machine;
    machine.valve = main_valve(parameters);
    machine.cross_over = cross_over_limits(parameters);
    for (Link link : all_links)
        machine.links[index_of(link)] = coupled_mechanics(link, parameters);
    machine.arm = arm_lengths(parameters);
    machine.gains = {parameters["tracking.proportional"], parameters["tracking.derivative"],
                     parameters["tracking.least_flow"], parameters["controller.inlet_drop"],
                     parameters["controller.bypass_drop"]};
    machine.joystick_lag_s = parameters["joystick.lag"];
    machine.bypass_rest_in2 = parameters["two_links.bucket_bypass_rest"];
    machine.dead_time_s = parameters["valve.dead_time"];
    machine.control_period_s = parameters["sensors.period"];
    machine.integration_step_s = parameters["digging.integration_step"];
    return machine;
}

} // namespace placedpar::hydraulics
