#include "app/single_link/boom_data.hpp"

#include "hydraulics/boom_record.hpp"
#include "hydraulics/voltage_spool.hpp"
#include "runtime/random.hpp"

#include <cmath>
#include <cstddef>

namespace placedpar {

namespace {

/// The drain side's pressure at the instants of the record, with noise of its own stream, so that the other channels
/// are those of every other user of the seed.
void add_outlet_pressure(Record& record, std::span<const BoomState> motion, const SimpleMotion& sensors) {
    RandomStream random(sensors.seed, "outlet sensor");
    std::size_t stride = (motion.size() - 1) / (record.size() - 1);
    for (std::size_t i = 0; i < record.size(); ++i) {
        double noise = sensors.noise.pressure_psi * standard_normal([&] { return random.uniform(); });
        double steps = std::nearbyint((motion[i * stride].outlet_psi + noise) / pressure_resolution_psi);
        record.of(MachineLink::boom, Sensor::outlet_pressure).push_back(steps * pressure_resolution_psi);
    }
}

/// The voltage that the controller asks for: that of the wanted spool by an A.1 that is off by the offset.
void add_voltage(Record& record, const BoomScenario& scenario, double offset_in) {
    double at_rest = servo_volts(scenario.spool_at_rest_in + offset_in);
    double stepped = servo_volts(scenario.spool_desired_in + offset_in);
    for (double time_s : record.time_s) {
        bool before = time_s < scenario.step_time_s - scenario.integration_step_s / 2;
        record.of(MachineLink::boom, Sensor::servo).push_back(before ? at_rest : stepped);
    }
}

} // namespace

BoomData simple_plant(const BoomScenario& scenario, const SimpleMotion& sensors, std::string noise_name) {
    RandomStream random(sensors.seed, "sensors");
    auto motion = simulate_boom(scenario);
    BoomData data{"simple plant, " + noise_name, {}, scenario.flow, scenario.machine, sensors.spool_offset_in};
    data.record = measure_boom(motion, scenario.machine.moment_arm_in, sampling_period_s, sensors.noise,
                               [&] { return random.uniform(); });
    for (double& spool : data.record.of(MachineLink::boom, Sensor::spool))
        spool += sensors.spool_offset_in;
    add_outlet_pressure(data.record, motion, sensors);
    add_voltage(data.record, scenario, sensors.spool_offset_in);
    return data;
}

BoomModel model_of(const BoomData& data, AreasFrom from) { return {from, data.machine.spool_lag_per_s, 0}; }

LinkReadings readings_of(const BoomData& data, const BoomModel& model) {
    LinkReadings readings = boom_readings(data.machine);
    LinkReading& boom = readings[index_of(MachineLink::boom)];
    boom.from = model.from;
    boom.spool_lag_per_s = model.spool_lag_per_s;
    boom.spool_offset_in = model.spool_offset_in;
    return readings;
}

std::vector<CircuitSample> samples_of(const BoomData& data, const BoomModel& model) {
    return circuit_samples(data.record, boom_circuit(), readings_of(data, model));
}

std::vector<double> spool_of(const BoomData& data, const BoomModel& model) {
    const Record& record = data.record;
    std::vector<double> spool =
        model.from == AreasFrom::servo
            ? spool_from_volts(record.of(MachineLink::boom, Sensor::servo), model.spool_lag_per_s, record.period_s)
            : record.of(MachineLink::boom, Sensor::spool);
    for (double& spool_in : spool)
        spool_in -= model.spool_offset_in;
    return spool;
}

} // namespace placedpar
