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

/// Who moves the boom: the plant whose structure is the model's own (single_boom_scenario), or the one with hoses,
/// stiction, pump ripple, dead time and converters (measured_excavator.hpp).
enum class BoomPlant : unsigned char { simple, measured };

/// A motion of the boom as its sensors saw it, and the machine that moved: what the experiments of 3.1 work on. All
/// they need of a source of records is this.
struct BoomData {
    hydraulics::Record record; ///< of the boom: both pressures, angle, spool, servo-valve's voltage
    hydraulics::FlowConstants flow;
    hydraulics::LinkMechanics boom; ///< as it truly is
};

/// A step of the boom, 4 deg/s of a machine of excavator.csv but for what is set here. A spool offset leaves the motion
/// alone: readings and A.1 are wrong alike, so that the controller asks for the voltage that moves the spool where it
/// is wanted.
struct BoomMotion {
    BoomPlant plant = BoomPlant::simple;
    hydraulics::MeasurementNoise noise = hydraulics::no_noise;
    double spool_offset_in = 0; ///< by which the spool's readings and A.1 are too high
    std::optional<double> inlet_compliance_in3_per_psi = {}, spool_desired_in = {}, duration_s = {};
    bool slow = false; ///< of the simple plant: scenario B, heavy and by a ramp
};

/// Simulates it once, and measures it with the noise of the streams (seed, "sensors") of each seed.
std::vector<BoomData> measure(const BoomMotion& motion, std::span<const std::uint64_t> seeds);
BoomData measure(const BoomMotion& motion, std::uint64_t seed);

/// Which areas the model takes, and what it believes.
struct BoomModel {
    hydraulics::AreasFrom from = hydraulics::AreasFrom::spool;
    double spool_lag_per_s = 0; ///< a_0 of A.2
    double spool_offset_in = 0; ///< taken off the readings or A.1
};
/// With the machine's own lag, no offset.
BoomModel model_of(const BoomData&, hydraulics::AreasFrom);

hydraulics::LinkCalibrations calibrations_of(const BoomData&, const BoomModel&);
/// Every instant at which the slopes are known.
std::vector<hydraulics::CircuitSample> samples_of(const BoomData&, const BoomModel&);
/// The spool that the model believes in, at every instant of the record, the offset taken off.
std::vector<double> spool_of(const BoomData&, const BoomModel&);

} // namespace placedpar
