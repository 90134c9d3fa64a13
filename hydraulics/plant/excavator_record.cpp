#include "hydraulics/plant/excavator_record.hpp"

#include <numbers>

namespace placedpar::hydraulics {

Record measure_excavator(const ExcavatorMotion& motion, const ExcavatorScenario& scenario, double period_s,
                         const MeasurementNoise& noise, const UniformSource& uniform) {
    Record record;
    record.period_s = period_s;
    std::size_t stride = steps_in(period_s, scenario.integration_step_s);
    for (std::size_t i = 0; i < motion.states.size(); i += stride) {
        record.time_s.push_back(motion.states[i].time_s);
        for (std::size_t l = 0; l < scenario.links.size(); ++l) {
            const LinkState& state = motion.states[i].links[l];
            const ActiveLink& link = scenario.links[l];
            auto read = [&](Sensor sensor, double value, double deviation, double resolution) {
                record.of(link.link, sensor)
                    .push_back(reading(value + deviation * standard_normal(uniform), resolution));
            };
            double angle_deg = state.piston_in / link.machine.moment_arm_in * 180 / std::numbers::pi;
            read(Sensor::inlet_pressure, state.inlet_psi, noise.pressure_psi, pressure_resolution_psi);
            read(Sensor::angle, angle_deg, noise.angle_deg, angle_resolution_deg);
            read(Sensor::inlet_area, state.areas.inlet_in2, noise.area_share * state.areas.inlet_in2,
                 area_resolution_in2);
            read(Sensor::bypass_area, state.areas.bypass_in2, noise.area_share * state.areas.bypass_in2,
                 area_resolution_in2);
        }
    }
    return record;
}

} // namespace placedpar::hydraulics
