#pragma once

#include "hydraulics/circuit/circuit_sample.hpp"
#include "hydraulics/data/record.hpp"
#include "hydraulics/plant/excavator_motion.hpp"
#include "hydraulics/plant/measurement.hpp"

#include <vector>

namespace placedpar::hydraulics {

/// Samples the motion of all links of a scenario every `period_s`, from its first state on: of each link the inlet
/// pressure, the angle, and its spool or, where its valve has none, the areas of its inlet and bypass, whose noise is
/// relative. Draws one normal number for each of these in this order, link after link, even without noise, so that two
/// levels see the same disturbance in proportion. Readings come in the steps of measurement.hpp. Throws UnfitScenario
/// (requirement.hpp) when the period is not a whole multiple of the motion's step.
Record measure_excavator(const ExcavatorMotion& motion, const ExcavatorScenario& scenario, double period_s,
                         const MeasurementNoise& noise, const UniformSource& uniform);

/// How the readings of the boom alone become flows and areas.
LinkCalibrations boom_calibrations(const LinkMechanics& boom);

/// Simulates a scenario of the boom alone (single_boom_scenario), measures it with noise at the thesis's period, and
/// takes the usable samples, as plain numbers in the order of LinkSample.
std::vector<std::vector<double>> boom_record(const ExcavatorScenario& scenario, const MeasurementNoise& noise,
                                             const UniformSource& uniform, const UsableSamples& usable = {});
/// The same of a motion that has been simulated. REQUIRES: it is the scenario's.
std::vector<std::vector<double>> boom_record(const ExcavatorMotion& motion, const ExcavatorScenario& scenario,
                                             const MeasurementNoise& noise, const UniformSource& uniform,
                                             const UsableSamples& usable = {});

} // namespace placedpar::hydraulics
