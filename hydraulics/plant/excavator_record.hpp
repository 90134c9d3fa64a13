#pragma once

#include "hydraulics/circuit/circuit_sample.hpp"
#include "hydraulics/data/record.hpp"
#include "hydraulics/plant/excavator_motion.hpp"
#include "hydraulics/plant/measurement.hpp"

#include <vector>

namespace placedpar::hydraulics {

/// Samples the motion of all links of a scenario every `period_s`, from the first state on. Reads the inlet pressure,
/// the angle and the spool of each link. For a valve without a spool, reads the areas of inlet and bypass, with noise
/// in proportion to the area. Draws one normal number for each reading in this order, link after link, even without
/// noise, so that the disturbances of two noise levels are proportional. Readings have the resolution of
/// measurement.hpp. Throws UnfitScenario (requirement.hpp) if the period is not a whole multiple of the motion's step.
Record measure_excavator(const ExcavatorMotion& motion, const ExcavatorScenario& scenario, double period_s,
                         const MeasurementNoise& noise, const UniformSource& uniform);

/// Returns the calibrations that convert the readings of the boom alone to flows and areas.
LinkCalibrations boom_calibrations(const LinkMechanics& boom);

/// Adds the voltage that the controller commands for the boom at every instant of the record. The controller computes
/// the voltage by A.1 for the desired spool position plus the error `offset_in`. REQUIRES: the scenario's first link is
/// the boom, with a spool that makes a step.
void add_servo_voltage(Record& record, const ExcavatorScenario& scenario, double offset_in = 0);

/// Simulates a scenario of the boom alone (single_boom_scenario), measures it with noise at the thesis's period, and
/// returns the usable samples. Each sample is a list of numbers in the order of LinkSample.
std::vector<std::vector<double>> boom_record(const ExcavatorScenario& scenario, const MeasurementNoise& noise,
                                             const UniformSource& uniform, const UsableSamples& usable = {});
/// Returns the usable samples of a motion that has been simulated already. The orifices' areas come from the measured
/// spool (thesis 3.1.3, experiment 1) or from the servo-valve's voltage (experiment 2). REQUIRES: `motion` is a
/// simulation of `scenario`.
std::vector<std::vector<double>> boom_record(const ExcavatorMotion& motion, const ExcavatorScenario& scenario,
                                             const MeasurementNoise& noise, const UniformSource& uniform,
                                             const UsableSamples& usable = {}, AreasFrom from = AreasFrom::spool);

} // namespace placedpar::hydraulics
