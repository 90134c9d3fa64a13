#pragma once

#include "hydraulics/data/record.hpp"
#include "hydraulics/plant/measurement.hpp"
#include "hydraulics/plant/moving_excavator.hpp"

namespace placedpar::hydraulics {

/// Simulates a job, and reads every link at the controller's times with noise: inlet pressure, angle, inlet area and
/// bypass area, in this order, link after link. The record also holds the true configuration. Throws what
/// simulate_moving() throws.
Record measure_moving(const MovingExcavator&, const DigJob&, const MeasurementNoise&, const UniformSource& uniform);

} // namespace placedpar::hydraulics
