#include "hydraulics/plant/moving_record.hpp"

#include "hydraulics/data/units.hpp"

namespace placedpar::hydraulics {

Record measure_moving(const MovingExcavator& machine, const DigJob& job, const MeasurementNoise& noise,
                      const UniformSource& uniform) {
    Record record;
    record.period_s = machine.control_period_s;
    auto read = [&](Link link, Sensor sensor, double value, double deviation, double resolution) {
        record.of(link, sensor).push_back(reading(value + deviation * standard_normal(uniform), resolution));
    };
    simulate_moving(machine, job, [&](const MovingState& state) {
        record.time_s.push_back(state.time_s);
        record.configuration += name_of(state.configuration);
        for (Link link : all_links) {
            const MovingLink& now = state.links[index_of(link)];
            const auto& [inlet, bypass, outlet] = now.areas;
            read(link, Sensor::inlet_pressure, now.inlet_psi, noise.pressure_psi, pressure_resolution_psi);
            read(link, Sensor::angle, now.angle_rad * deg_per_rad, noise.angle_deg, angle_resolution_deg);
            read(link, Sensor::inlet_area, inlet, noise.area_share * inlet, area_resolution_in2);
            read(link, Sensor::bypass_area, bypass, noise.area_share * bypass, area_resolution_in2);
        }
    });
    return record;
}

} // namespace placedpar::hydraulics
