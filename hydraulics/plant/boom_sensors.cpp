#include "hydraulics/plant/boom_sensors.hpp"

#include <cmath>
#include <cstddef>

namespace placedpar::hydraulics {

BoomSensors boom_sensors(const Parameters& parameters) {
    constexpr double whole_turn_deg = 360;
    return {.noise = measurement_noise(parameters),
            .pressure = {parameters["sensors.pressure_range"], bits_of(parameters, "sensors.pressure_bits")},
            .resolver = {whole_turn_deg, bits_of(parameters, "sensors.resolver_bits")},
            .spool = {parameters["sensors.spool_range"], bits_of(parameters, "sensors.spool_bits")},
            .spool_offset_in = parameters["fault.spool_offset"],
            .joint_at_rest_deg = parameters["excavator.joint_at_rest"],
            .period_s = parameters["sensors.period"]};
}

void read_boom_sensors(const MeasuredState& state, const MeasuredExcavator& excavator, const BoomSensors& sensors,
                       const UniformSource& uniform, Record& record) {
    auto read = [&](Sensor sensor, double value) { record.of(Link::boom, sensor).push_back(value); };
    double inlet = state.inlet_psi + sensors.noise.pressure_psi * standard_normal(uniform);
    double outlet = state.outlet_psi + sensors.noise.pressure_psi * standard_normal(uniform);
    double angle = sensors.joint_at_rest_deg + excavator.boom.joint_deg(state.piston_in) +
                   sensors.noise.angle_deg * standard_normal(uniform);
    double spool = state.spool_in + sensors.spool_offset_in + sensors.noise.spool_in * standard_normal(uniform);
    record.time_s.push_back(static_cast<double>(record.time_s.size()) * sensors.period_s);
    read(Sensor::inlet_pressure, sensors.pressure.limited(inlet, 0));
    read(Sensor::outlet_pressure, sensors.pressure.limited(outlet, 0));
    read(Sensor::angle, sensors.resolver(angle));
    read(Sensor::spool, sensors.spool.limited(spool, 0));
}

Record read_boom_sensors(std::span<const MeasuredState> motion, const MeasuredExcavator& excavator,
                         const BoomSensors& sensors, const UniformSource& uniform) {
    std::size_t stride = steps_in(sensors.period_s, step_of(motion));
    Record record;
    record.period_s = sensors.period_s;
    for (std::size_t i = 0; i < motion.size(); i += stride) {
        read_boom_sensors(motion[i], excavator, sensors, uniform, record);
        record.of(Link::boom, Sensor::servo).push_back(held_volts(excavator, motion[i].time_s));
    }
    return record;
}

} // namespace placedpar::hydraulics
