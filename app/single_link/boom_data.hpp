#pragma once

#include "hydraulics/boom_scenario.hpp"
#include "hydraulics/circuit_sample.hpp"
#include "hydraulics/measurement.hpp"
#include "hydraulics/record.hpp"

#include <cstdint>
#include <string>

namespace placedpar {

/// A motion of the boom as its sensors saw it, and the machine that moved: what the experiments of 3.1 work on. All
/// they need of a source of records is this.
struct BoomData {
    std::string plant; ///< for people: "simple plant, low noise"
    Record record;     ///< of the boom: both pressures, angle, spool, servo-valve's voltage
    FlowConstants flow;
    BoomMachine machine;             ///< as it truly is
    double true_spool_offset_in = 0; ///< by which the spool's readings and A.1 are too high
};

/// Scenario A with another final spool and, perhaps, another compliance, of the plant that has the model's own
/// structure; its sensors' noise is drawn from the stream (seed, "sensors"), as the tests of identification do. A
/// spool offset leaves the motion alone: readings and A.1 are wrong alike, so that the controller asks for the voltage
/// that moves the spool where it is wanted.
struct SimpleMotion {
    MeasurementNoise noise = no_noise;
    std::uint64_t seed = 1;
    double spool_offset_in = 0;
};
BoomData simple_plant(const BoomScenario& scenario, const SimpleMotion& motion, std::string noise_name);

/// Which areas the model takes, and what it believes.
struct BoomModel {
    AreasFrom from = AreasFrom::spool;
    double spool_lag_per_s = 0; ///< a_0 of A.2
    double spool_offset_in = 0; ///< taken off the readings or A.1
};
/// With the machine's own lag, no offset.
BoomModel model_of(const BoomData&, AreasFrom);

LinkReadings readings_of(const BoomData&, const BoomModel&);
/// Every instant at which the slopes are known.
std::vector<CircuitSample> samples_of(const BoomData&, const BoomModel&);
/// The spool that the model believes in, at every instant of the record, the offset taken off.
std::vector<double> spool_of(const BoomData&, const BoomModel&);

} // namespace placedpar
