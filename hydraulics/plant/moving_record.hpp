#pragma once

#include "hydraulics/data/record.hpp"
#include "hydraulics/plant/measurement.hpp"
#include "hydraulics/plant/moving_excavator.hpp"

namespace placedpar::hydraulics {

/// Simulates a digging job, and records noisy readings of every link once in each period of the controller. A link's
/// readings are inlet pressure, angle, inlet area and bypass area. Random numbers are drawn in this order, link after
/// link. The record also holds the true configuration of the main valve. Throws what simulate_moving() throws.
Record measure_moving(const MovingExcavator&, const DigJob&, const MeasurementNoise&, const UniformSource& uniform);

} // namespace placedpar::hydraulics
