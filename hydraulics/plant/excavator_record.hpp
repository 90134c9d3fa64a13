#pragma once

#include "hydraulics/circuit/circuit_sample.hpp"
#include "hydraulics/data/record.hpp"
#include "hydraulics/plant/excavator_motion.hpp"
#include "hydraulics/plant/measurement.hpp"

#include <vector>

namespace placedpar::hydraulics {

/// Returns what sensors would read every `period_s` during a simulated motion, from the first state on. Each link has
/// readings of the inlet pressure, the angle and the spool. A valve without a spool has readings of the areas of inlet
/// and bypass instead, with noise in proportion to the area. Draws one normal number for each reading in this order,
/// link after link, even without noise. With the same random numbers, the errors at two noise levels are therefore
/// proportional. Readings are rounded to the resolution of measurement.hpp. Throws UnfitScenario (requirement.hpp) if
/// the period is not a whole multiple of the motion's step.
Record measure_excavator(const ExcavatorMotion& motion, const ExcavatorScenario& scenario, double period_s,
                         const MeasurementNoise& noise, const UniformSource& uniform);

/// Returns the calibrations that convert the readings of the boom alone to flows and areas.
LinkCalibrations boom_calibrations(const LinkMechanics& boom);

/// Adds the voltage that the controller commands for the boom at every instant of the record. The voltage is that of
/// the desired spool position plus the error `offset_in` (A.1). REQUIRES: the scenario's first link is the boom, with a
/// spool that makes a step.
void add_servo_voltage(Record& record, const ExcavatorScenario& scenario, double offset_in = 0);

/// Simulates a scenario in which only the boom moves (single_boom_scenario()). Measures the motion with noise every 20
/// ms, and returns the samples that identification can use. Each sample is a list of numbers in the order of
/// LinkSample's members.
std::vector<std::vector<double>> boom_record(const ExcavatorScenario& scenario, const MeasurementNoise& noise,
                                             const UniformSource& uniform, const UsableSamples& usable = {});
/// Returns the samples that identification can use from a motion that has been simulated already. The orifices' areas
/// come from the measured spool (thesis 3.1.3, experiment 1) or from the servo-valve's voltage (experiment 2).
/// REQUIRES: `motion` is a simulation of `scenario`.
std::vector<std::vector<double>> boom_record(const ExcavatorMotion& motion, const ExcavatorScenario& scenario,
                                             const MeasurementNoise& noise, const UniformSource& uniform,
                                             const UsableSamples& usable = {}, AreasFrom from = AreasFrom::spool);

} // namespace placedpar::hydraulics
