#pragma once

#include "hydraulics/data/record.hpp"
#include "hydraulics/plant/excavator_motion.hpp"
#include "hydraulics/plant/measurement.hpp"

namespace placedpar::hydraulics {

/// Samples the motion of all links of a scenario every `period_s`, from its first state on: of each link the inlet
/// pressure, the angle, and the areas of its inlet and bypass, whose noise is relative. Draws four normal numbers a
/// link and sample in the order pressure, angle, inlet, bypass, whatever the noise. Readings come in the steps of
/// measurement.hpp. Throws std::invalid_argument when the period is no whole multiple of the motion's step.
Record measure_excavator(const ExcavatorMotion& motion, const ExcavatorScenario& scenario, double period_s,
                         const MeasurementNoise& noise, const UniformSource& uniform);

} // namespace placedpar::hydraulics
