#include "hydraulics/plant/boom_record.hpp"

#include <numbers>

namespace placedpar::hydraulics {

Circuit boom_circuit() { return circuit_of(Configuration::a, {Link::boom}); }

LinkReadings boom_readings(const BoomMachine& machine) {
    LinkReadings readings;
    readings[index_of(Link::boom)].piston_flow_in3_per_deg =
        machine.inlet_area_in2 * machine.moment_arm_in * std::numbers::pi / 180;
    readings[index_of(Link::boom)].spool_lag_per_s = machine.spool_lag_per_s;
    return readings;
}

std::vector<std::vector<double>> boom_record(const BoomScenario& scenario, const MeasurementNoise& noise,
                                             const UniformSource& uniform, const UsableSamples& usable) {
    Record measured =
        measure_boom(simulate_boom(scenario), scenario.machine.moment_arm_in, sampling_period_s, noise, uniform);
    Circuit circuit = boom_circuit();
    auto samples = circuit_samples(measured, circuit, boom_readings(scenario.machine));
    std::vector<std::vector<double>> record;
    for (const CircuitSample& sample : usable_samples(samples, circuit, scenario.flow, usable))
        record.push_back(sample.values());
    return record;
}

} // namespace placedpar::hydraulics
