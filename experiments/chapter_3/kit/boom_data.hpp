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

/// Selects the simulated plant. `simple` has the structure of the model (single_boom_scenario); `measured` also has
/// hoses, stiction, pump ripple, dead time and converters (measured_excavator.hpp).
enum class BoomPlant : unsigned char { simple, measured };

/// A motion of the boom as its sensors recorded it, and the machine that moved. The experiments of thesis 3.1 need no
/// other data.
struct BoomData {
    hydraulics::Record record; ///< of the boom: both pressures, angle, spool, voltage of the servo-valve
    hydraulics::FlowConstants flow;
    hydraulics::LinkMechanics boom; ///< the true values
};

/// A step of the boom to 4 deg/s. The machine is that of excavator.csv, except for the values set here. A spool offset
/// does not change the motion. The readings and A.1 have the same error, so the controller's voltage moves the spool to
/// the right place.
struct BoomMotion {
    BoomPlant plant = BoomPlant::simple;
    hydraulics::MeasurementNoise noise = hydraulics::no_noise;
    double spool_offset_in = 0; ///< amount by which the spool's readings and A.1 are too high
    std::optional<double> inlet_compliance_in3_per_psi = {}, spool_desired_in = {}, duration_s = {};
    bool slow = false; ///< on the simple plant: scenario B, heavy and with a ramp
};

/// Simulates the motion once, and measures it for each seed with the noise of the streams (seed, "sensors").
std::vector<BoomData> measure(const BoomMotion& motion, std::span<const std::uint64_t> seeds);
BoomData measure(const BoomMotion& motion, std::uint64_t seed);

/// The model's source of areas, and its assumptions.
struct BoomModel {
    hydraulics::AreasFrom from = hydraulics::AreasFrom::spool;
    double spool_lag_per_s = 0; ///< a_0 of A.2
    double spool_offset_in = 0; ///< subtracted from the readings or A.1
};
/// Returns a model with the machine's own lag and no offset.
BoomModel model_of(const BoomData&, hydraulics::AreasFrom);

hydraulics::LinkCalibrations calibrations_of(const BoomData&, const BoomModel&);
/// Returns a sample for every instant at which the slopes are known.
std::vector<hydraulics::CircuitSample> samples_of(const BoomData&, const BoomModel&);
/// Returns the spool according to the model at every instant of the record, with the offset subtracted.
std::vector<double> spool_of(const BoomData&, const BoomModel&);

} // namespace placedpar
