#include "experiments/chapter_3/kit/boom_data.hpp"

#include "hydraulics/circuit/voltage_spool.hpp"
#include "hydraulics/plant/boom_sensors.hpp"
#include "hydraulics/plant/excavator_record.hpp"
#include "hydraulics/plant/excavator_values.hpp"
#include "hydraulics/plant/measured_motion.hpp"
#include "hydraulics/plant/record_scenario.hpp"
#include "runtime/random.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace placedpar {

using namespace hydraulics;

namespace {

Parameters parameters_of(const BoomMotion& motion) {
    Parameters all = Parameters::excavator();
    if (motion.plant == BoomPlant::simple && motion.slow)
        all = record_scenario_named("scenario-b")->parameters(all);
    std::string scenario = motion.slow ? "scenario_b" : "scenario_a";
    double desired = motion.spool_desired_in.value_or(all[scenario + ".spool_desired"]);
    double duration = motion.duration_s.value_or(all[scenario + ".duration"]);
    all.set(scenario + ".spool_desired", desired);
    all.set(scenario + ".duration", duration);
    all.set("excavator.servo_at_rest", servo_volts(all["scenario_a.spool_at_rest"] + motion.spool_offset_in));
    all.set("excavator.servo_desired", servo_volts(desired + motion.spool_offset_in));
    all.set("excavator.duration", duration);
    all.set("fault.spool_offset", motion.spool_offset_in);
    all.set("noise.pressure", motion.noise.pressure_psi);
    all.set("noise.angle", motion.noise.angle_deg);
    all.set("noise.spool", motion.noise.spool_in);
    if (motion.inlet_compliance_in3_per_psi)
        all.set("boom.inlet_compliance", *motion.inlet_compliance_in3_per_psi);
    return all;
}

/// Adds the drain side's pressure at the record's instants. The noise of this pressure has its own random stream, so
/// the noise of the other channels does not change when this channel is added.
void add_outlet_pressure(Record& record, std::span<const ExcavatorState> states, double noise_psi, std::uint64_t seed) {
    RandomStream random(seed, "outlet sensor");
    std::size_t stride = (states.size() - 1) / (record.size() - 1);
    for (std::size_t i = 0; i < record.size(); ++i) {
        double noise = noise_psi * standard_normal([&] { return random.uniform(); });
        double steps = std::nearbyint((states[i * stride].links.front().outlet_psi + noise) / pressure_resolution_psi);
        record.of(Link::boom, Sensor::outlet_pressure).push_back(steps * pressure_resolution_psi);
    }
}

std::vector<BoomData> measure_simple(const BoomMotion& motion, std::span<const std::uint64_t> seeds) {
    ExcavatorScenario scenario = single_boom_scenario(parameters_of(motion), motion.slow ? "scenario_b" : "scenario_a");
    ExcavatorMotion simulated = simulate_excavator(scenario);
    std::vector<BoomData> all;
    for (std::uint64_t seed : seeds) {
        RandomStream random(seed, "sensors");
        Record record =
            measure_excavator(simulated, scenario, sampling_period_s, motion.noise, [&] { return random.uniform(); });
        for (double& spool : record.of(Link::boom, Sensor::spool))
            spool += motion.spool_offset_in;
        add_outlet_pressure(record, simulated.states, motion.noise.pressure_psi, seed);
        add_servo_voltage(record, scenario, motion.spool_offset_in);
        all.push_back({std::move(record), scenario.flow, scenario.links.front().mechanics});
    }
    return all;
}

std::vector<BoomData> measure_measured(const BoomMotion& motion, std::span<const std::uint64_t> seeds) {
    Parameters parameters = parameters_of(motion);
    MeasuredExcavator excavator = measured_excavator(parameters);
    auto states = simulate_measured_excavator(excavator);
    std::vector<BoomData> all;
    for (std::uint64_t seed : seeds) {
        RandomStream random(seed, "sensors");
        all.push_back({read_boom_sensors(states, excavator, boom_sensors(parameters), [&] { return random.uniform(); }),
                       excavator.flow, excavator.boom});
    }
    return all;
}

} // namespace

std::vector<BoomData> measure(const BoomMotion& motion, std::span<const std::uint64_t> seeds) {
    return motion.plant == BoomPlant::simple ? measure_simple(motion, seeds) : measure_measured(motion, seeds);
}

BoomData measure(const BoomMotion& motion, std::uint64_t seed) { return measure(motion, std::array{seed}).front(); }

BoomModel model_of(const BoomData& data, AreasFrom from) { return {from, data.boom.spool_lag_per_s, 0}; }

LinkCalibrations calibrations_of(const BoomData& data, const BoomModel& model) {
    LinkCalibrations calibrations = boom_calibrations(data.boom);
    LinkCalibration& boom = calibrations[index_of(Link::boom)];
    boom.from = model.from;
    boom.constants.spool_lag_per_s = model.spool_lag_per_s;
    boom.spool_offset_in = model.spool_offset_in;
    return calibrations;
}

std::vector<CircuitSample> samples_of(const BoomData& data, const BoomModel& model) {
    return circuit_samples(data.record, boom_circuit(), calibrations_of(data, model));
}

std::vector<double> spool_of(const BoomData& data, const BoomModel& model) {
    const Record& record = data.record;
    std::vector<double> spool =
        model.from == AreasFrom::servo
            ? spool_from_volts(record.of(Link::boom, Sensor::servo), model.spool_lag_per_s, record.period_s)
            : record.of(Link::boom, Sensor::spool);
    for (double& spool_in : spool)
        spool_in -= model.spool_offset_in;
    return spool;
}

} // namespace placedpar
