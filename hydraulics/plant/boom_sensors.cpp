#include "hydraulics/plant/boom_sensors.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>

namespace placedpar::hydraulics {

namespace {

constexpr double whole_turn_deg = 360;

} // namespace

BoomSensors::BoomSensors(const Parameters& p)
    : noise{p["noise.pressure"], p["noise.angle"], p["noise.spool"]}, pressure{p["sensors.pressure_range"],
                                                                               bits_of(p, "sensors.pressure_bits")},
      resolver{whole_turn_deg, bits_of(p, "sensors.resolver_bits")}, spool{p["sensors.spool_range"],
                                                                           bits_of(p, "sensors.spool_bits")},
      spool_offset_in(p["fault.spool_offset"]), joint_at_rest_deg(p["excavator.joint_at_rest"]),
      period_s(p["sensors.period"]) {}

Record read_boom_sensors(std::span<const MeasuredState> motion, const MeasuredMachine& machine,
                         const BoomSensors& sensors, const UniformSource& uniform) {
    std::size_t stride = steps_in(sensors.period_s, step_of(motion));
    constexpr double deg_per_rad = 180 / std::numbers::pi;
    Record record;
    record.period_s = sensors.period_s;
    auto read = [&](Sensor sensor, double value) { record.of(Link::boom, sensor).push_back(value); };
    for (std::size_t i = 0; i < motion.size(); i += stride) {
        const MeasuredState& state = motion[i];
        double inlet = state.inlet_psi + sensors.noise.pressure_psi * standard_normal(uniform);
        double outlet = state.outlet_psi + sensors.noise.pressure_psi * standard_normal(uniform);
        double angle = sensors.joint_at_rest_deg + state.piston_in / machine.boom.moment_arm_in * deg_per_rad +
                       sensors.noise.angle_deg * standard_normal(uniform);
        double spool = state.spool_in + sensors.spool_offset_in + sensors.noise.spool_in * standard_normal(uniform);
        record.time_s.push_back(static_cast<double>(record.time_s.size()) * sensors.period_s);
        read(Sensor::inlet_pressure, sensors.pressure.limited(inlet, 0));
        read(Sensor::outlet_pressure, sensors.pressure.limited(outlet, 0));
        read(Sensor::angle, sensors.resolver(angle));
        read(Sensor::spool, sensors.spool.limited(spool, 0));
        read(Sensor::servo, held_volts(machine, state.time_s));
    }
    return record;
}

} // namespace placedpar::hydraulics
