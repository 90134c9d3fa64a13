#pragma once

#include "hydraulics/data/record.hpp"
#include "hydraulics/plant/converter.hpp"
#include "hydraulics/plant/measured_motion.hpp"
#include "hydraulics/plant/measurement.hpp"

#include <span>

namespace placedpar::hydraulics {

/// The sensors of the measured excavator's boom. Each reading is the true value with noise, rounded by a converter.
struct BoomSensors {
    MeasurementNoise noise;
    Converter pressure;     ///< its range begins at 0 psi
    Converter resolver;     ///< its range is 360 deg
    Converter spool;        ///< its range begins at 0 in
    double spool_offset_in; ///< amount by which the spool's sensor reads too high
    double joint_at_rest_deg;
    double period_s;
};

/// Reads the rows sensors.*, noise.*, fault.spool_offset and excavator.joint_at_rest.
BoomSensors boom_sensors(const Parameters& parameters = Parameters::excavator());

/// Adds one reading of each sensor at this state: both pressures, each at the valve's end of its hose, the angle and
/// the spool. Draws four normal numbers, in the order inlet pressure, outlet pressure, angle, spool, even without
/// noise.
void read_boom_sensors(const MeasuredState& state, const MeasuredExcavator& excavator, const BoomSensors& sensors,
                       const UniformSource& uniform, Record& record);

/// Reads every sensor of the boom once a period: both pressures, each at the valve's end of its hose, the angle, the
/// spool, and the voltage that the control system commanded. Throws UnfitScenario (requirement.hpp) if the period is
/// not a whole multiple of the motion's step.
Record read_boom_sensors(std::span<const MeasuredState> motion, const MeasuredExcavator& excavator,
                         const BoomSensors& sensors, const UniformSource& uniform);

} // namespace placedpar::hydraulics
