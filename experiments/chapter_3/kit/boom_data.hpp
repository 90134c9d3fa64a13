#pragma once

#include "hydraulics/circuit/circuit_sample.hpp"
#include "hydraulics/data/record.hpp"
#include "hydraulics/plant/link_mechanics.hpp"
#include "hydraulics/plant/measurement.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace placedpar {

/// Selects the simulated excavator, whose compliance is searched for. `simple` has the same structure as the search's
/// model (single_boom_scenario). `measured` also has hoses, stiction, pump ripple, dead time and converters
/// (measured_excavator.hpp).
enum class BoomPlant : unsigned char { simple, measured };

/// A motion of the boom as recorded by the sensors, and the machine's constants.
struct BoomData {
    hydraulics::Record record; ///< both pressures, angle, spool and servo-valve voltage of the boom
    hydraulics::FlowConstants flow;
    hydraulics::LinkMechanics boom; ///< the true values of the boom's constants
};

/// A step of the boom's velocity to 4 deg/s. The constants of the machine come from `excavator.csv`, except for the
/// values set here. Equation A.1 relates the valve's voltage to its spool position. A spool offset does not change the
/// motion, because the controller's equation A.1 has the same error as the readings. So the spool still moves to the
/// intended position.
struct BoomMotion {
    BoomPlant plant = BoomPlant::simple;
    hydraulics::MeasurementNoise noise = hydraulics::no_noise;
    double spool_offset_in = 0; ///< error of the spool's readings and of equation A.1; positive: too high
    std::optional<double> inlet_compliance_in3_per_psi = {}, spool_desired_in = {}, duration_s = {};
    bool slow = false; ///< whether to run scenario B, which has a heavier load and a ramp instead of the step; only for
                       ///< BoomPlant::simple
};

/// Simulates the motion once, then measures it once for each seed. The noise comes from the random stream of the seed
/// with the name "sensors".
std::vector<BoomData> measure(const BoomMotion& motion, std::span<const std::uint64_t> seeds);
BoomData measure(const BoomMotion& motion, std::uint64_t seed);

/// The source from which the model takes the areas of the valve's orifices, and its assumptions about this source.
struct BoomModel {
    hydraulics::AreasFrom from = hydraulics::AreasFrom::spool;
    double spool_lag_per_s = 0; ///< a_0 of equation A.2, the rate at which the spool follows the voltage
    double spool_offset_in = 0; ///< subtracted from the spool position that the readings or equation A.1 give
};
/// Returns a model with the machine's true lag and no offset.
BoomModel model_of(const BoomData&, hydraulics::AreasFrom);

hydraulics::LinkCalibrations calibrations_of(const BoomData&, const BoomModel&);
/// Returns a sample for every instant at which the slopes of pressure and angle are known.
std::vector<hydraulics::CircuitSample> samples_of(const BoomData&, const BoomModel&);
/// Returns the spool position that the model gives at every instant of the record, with the offset subtracted.
std::vector<double> spool_of(const BoomData&, const BoomModel&);

} // namespace placedpar
