#include "hydraulics/circuit/voltage_spool.hpp"
#include "hydraulics/plant/excavator_record.hpp"
#include "hydraulics/plant/excavator_values.hpp"
#include "identification/offset_calibration.hpp"
#include "runtime/random.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace placedpar;
using namespace placedpar::hydraulics;
using namespace placedpar::identification;

namespace {

/// Returns a record of scenario A that ends long after the transient, with spool readings too high by `offset_in`.
Record steady_record(double offset_in, const MeasurementNoise& noise, std::uint64_t seed = 1) {
    ExcavatorScenario scenario = single_boom_scenario();
    scenario.duration_s = 4;
    RandomStream random(seed, "sensors");
    Record record = measure_excavator(simulate_excavator(scenario), scenario, sampling_period_s, noise,
                                      [&] { return random.uniform(); });
    for (double& spool : record.of(Link::boom, Sensor::spool))
        spool += offset_in;
    return record;
}

std::optional<SpoolOffset> calibrate(const Record& record, FlowConstants flow = fitted_flow_constants()) {
    return calibrate_spool_offset(record, boom_calibrations(single_boom_mechanics()), flow);
}

} // namespace

TEST_CASE("steady motion gives the spool's offset at every noise level") {
    for (double offset : {-0.02, -0.01, 0.0, 0.01, 0.02}) {
        CHECK(std::abs(calibrate(steady_record(offset, no_noise))->offset_in - offset) < 2e-4);
        CHECK(std::abs(calibrate(steady_record(offset, low_noise))->offset_in - offset) < 3e-4);
    }
    double squares = 0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed)
        squares += std::pow(calibrate(steady_record(0.01, mid_noise, seed))->offset_in - 0.01, 2);
    CHECK(std::sqrt(squares / 20) < 3e-4); // .00008 in in an independent prototype; the end of the transient adds to it
}

TEST_CASE("the position by the voltage is calibrated without the spool's readings") {
    LinkCalibrations by_voltage = boom_calibrations(single_boom_mechanics());
    by_voltage[index_of(Link::boom)].from = AreasFrom::servo;
    for (double of_voltage : {-0.01, 0.0, 0.01}) {
        Record record = steady_record(0, no_noise);
        for (double spool_in : record.of(Link::boom, Sensor::spool))
            record.of(Link::boom, Sensor::servo).push_back(servo_volts(spool_in + of_voltage));
        for (double& spool_in : record.of(Link::boom, Sensor::spool))
            spool_in += 0.02;
        const auto found = calibrate_spool_offset(record, by_voltage, fitted_flow_constants());
        CHECK(std::abs(found->offset_in - of_voltage) < 2e-4);
        CHECK(std::abs(calibrate(record)->offset_in - 0.02) < 2e-4);
    }
}

TEST_CASE("the calibration mistakes a wrong k or Q for an offset") {
    Record record = steady_record(0, no_noise);
    FlowConstants flow = fitted_flow_constants();
    flow.orifice_in3_per_s_in2_sqrt_psi *= 1.01;
    double of_k = calibrate(record, flow)->offset_in - calibrate(record)->offset_in;
    flow = fitted_flow_constants();
    flow.pump_in3_per_s *= 1.01;
    double of_q = calibrate(record, flow)->offset_in - calibrate(record)->offset_in;
    CHECK(std::abs(std::abs(of_k) - 0.0011) < 2e-4);
    CHECK(std::abs(std::abs(of_q) - 0.0016) < 2e-4);
    CHECK(of_k * of_q < 0);
}

TEST_CASE("without steady motion there is no calibration") {
    ExcavatorScenario scenario = single_boom_scenario();
    scenario.duration_s = 0.8;
    Record record =
        measure_excavator(simulate_excavator(scenario), scenario, sampling_period_s, no_noise, [] { return 0.0; });
    CHECK(!calibrate(record));
}

TEST_CASE("an impossible offset is not reported") {
    CHECK(!calibrate(steady_record(0, no_noise), {99.83, 800, 16.2, 4500}));
}
