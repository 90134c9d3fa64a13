#pragma once

#include "hydraulics/circuit/circuit_sample.hpp"
#include "hydraulics/plant/boom_scenario.hpp"
#include "hydraulics/plant/measurement.hpp"

#include <vector>

namespace placedpar::hydraulics {

/// The boom alone, fed by its pump.
Circuit boom_circuit();
/// What the boom's readings mean on a machine.
LinkReadings boom_readings(const BoomMachine& machine);

/// The whole way: simulate the scenario, measure it with noise, take the usable samples, as plain numbers in
/// the order of LinkSample.
std::vector<std::vector<double>> boom_record(const BoomScenario& scenario, const MeasurementNoise& noise,
                                             const UniformSource& uniform, const UsableSamples& usable = {});

} // namespace placedpar::hydraulics
