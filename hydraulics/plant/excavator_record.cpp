#include "hydraulics/plant/excavator_record.hpp"

#include "hydraulics/circuit/voltage_spool.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <variant>

namespace placedpar::hydraulics {

namespace {

void read_link(const LinkState& state, const ActiveLink& active, const MeasurementNoise& noise,
               const UniformSource& uniform, Record& record) {
    auto read = [&](Sensor sensor, double value, double deviation, double resolution) {
        record.of(active.link, sensor).push_back(reading(value + deviation * standard_normal(uniform), resolution));
    };
    auto read_area = [&](Sensor sensor, double area_in2) {
        read(sensor, area_in2, noise.area_share * area_in2, area_resolution_in2);
    };
    read(Sensor::inlet_pressure, state.inlet_psi, noise.pressure_psi, pressure_resolution_psi);
    read(Sensor::angle, active.mechanics.joint_deg(state.piston_in), noise.angle_deg, angle_resolution_deg);
    if (std::holds_alternative<SpoolOrifices>(active.valve)) {
        read(Sensor::spool, state.spool_in, noise.spool_in, spool_resolution_in);
    } else {
        read_area(Sensor::inlet_area, state.areas.inlet_in2);
        read_area(Sensor::bypass_area, state.areas.bypass_in2);
    }
}

} // namespace

Record measure_excavator(const ExcavatorMotion& motion, const ExcavatorScenario& scenario, double period_s,
                         const MeasurementNoise& noise, const UniformSource& uniform) {
    Record record;
    record.period_s = period_s;
    std::size_t stride = steps_in(period_s, step_of(std::span<const ExcavatorState>(motion.states)));
    for (std::size_t i = 0; i < motion.states.size(); i += stride) {
        record.time_s.push_back(motion.states[i].time_s);
        for (std::size_t l = 0; l < scenario.links.size(); ++l)
            read_link(motion.states[i].links[l], scenario.links[l], noise, uniform, record);
    }
    return record;
}

LinkCalibrations boom_calibrations(const LinkMechanics& boom) {
    LinkCalibrations calibrations;
    calibrations[index_of(Link::boom)].constants = {piston_in3_per_rad(boom.inlet_area_in2, boom.moment_arm_in),
                                                    boom.spool_lag_per_s};
    return calibrations;
}

void add_servo_voltage(Record& record, const ExcavatorScenario& scenario, double offset_in) {
    const auto& valve = std::get<SpoolOrifices>(scenario.links.front().valve);
    const SpoolStep& step = valve.steps.front();
    for (double time_s : record.time_s) {
        double since_s = time_s - step.time_s + scenario.integration_step_s / 2;
        double gone = since_s < 0 ? 0 : step.ramp_s > 0 ? std::min(since_s / step.ramp_s, 1.0) : 1;
        double wanted = std::lerp(valve.rest_in, step.desired_in, gone);
        record.of(Link::boom, Sensor::servo).push_back(servo_volts(wanted + offset_in));
    }
}

std::vector<std::vector<double>> boom_record(const ExcavatorScenario& scenario, const MeasurementNoise& noise,
                                             const UniformSource& uniform, const UsableSamples& usable) {
    return boom_record(simulate_excavator(scenario), scenario, noise, uniform, usable);
}

std::vector<std::vector<double>> boom_record(const ExcavatorMotion& motion, const ExcavatorScenario& scenario,
                                             const MeasurementNoise& noise, const UniformSource& uniform,
                                             const UsableSamples& usable, AreasFrom from) {
    Record measured = measure_excavator(motion, scenario, sampling_period_s, noise, uniform);
    LinkCalibrations calibrations = boom_calibrations(scenario.links.front().mechanics);
    calibrations[index_of(Link::boom)].from = from;
    if (from == AreasFrom::servo)
        add_servo_voltage(measured, scenario);
    Circuit circuit = boom_circuit();
    auto samples = circuit_samples(measured, circuit, calibrations);
    std::vector<std::vector<double>> record;
    for (const CircuitSample& sample : usable_samples(samples, circuit, scenario.flow, usable))
        record.push_back(sample.values());
    return record;
}

} // namespace placedpar::hydraulics
