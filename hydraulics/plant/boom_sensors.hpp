#pragma once

#include "hydraulics/data/record.hpp"
#include "hydraulics/plant/converter.hpp"
#include "hydraulics/plant/measured_motion.hpp"
#include "hydraulics/plant/measurement.hpp"

#include <span>

namespace placedpar::hydraulics {

/// The sensors of the boom in the detailed model of measured_excavator.hpp. Each reading is the true value plus noise,
/// rounded by an analogue-to-digital converter.
struct BoomSensors {
    MeasurementNoise noise;
    Converter pressure;     ///< its range begins at 0 psi
    Converter resolver;     ///< its range is 360 deg
    Converter spool;        ///< its range begins at 0 in
    double spool_offset_in; ///< amount by which the spool's sensor reads too high
    double joint_at_rest_deg;
    double period_s;
};

/// Reads the parameters sensors.*, noise.*, fault.spool_offset and excavator.joint_at_rest.
BoomSensors boom_sensors(const Parameters& parameters = Parameters::excavator());

/// Adds one reading of each sensor to `record`: both pressures, the angle and the spool. The pressures are those at the
/// valve's ends of the hoses. Draws four normal numbers, in the order inlet pressure, outlet pressure, angle, spool,
/// even without noise.
void read_boom_sensors(const MeasuredState& state, const MeasuredExcavator& excavator, const BoomSensors& sensors,
                       const UniformSource& uniform, Record& record);

/// Returns a record of a whole motion. Each period has one reading of every sensor, and the voltage that the control
/// system commanded. Throws UnfitScenario (requirement.hpp) if the period is not a whole multiple of the motion's step.
Record read_boom_sensors(std::span<const MeasuredState> motion, const MeasuredExcavator& excavator,
                         const BoomSensors& sensors, const UniformSource& uniform);

} // namespace placedpar::hydraulics
