#pragma once

#include "hydraulics/boom_problem.hpp"
#include "hydraulics/boom_scenario.hpp"
#include "hydraulics/measurement.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace placedpar {

/// Which samples identification may use (ours; the thesis says "during the transient period").
struct UsableSamples {
    double open_by_psi = 25;            // the first sample: the path is predicted open by more than this ...
    double first_slope_psi_per_s = 150; // ... and the pressure rises faster than this
    std::size_t count = 20;             // 0.4 s of transient, thesis 4.4
};

/// Turns measurements into what the error needs: slopes from 5-point lines, areas from the spool. Starts at
/// the first sample that UsableSamples accepts and leaves out later ones where the inlet is shut or the pump
/// cannot reach the cylinder's pressure, since equation 3.6 does not hold there. Gives fewer than `count`
/// when the record ends. Throws std::invalid_argument when the measurements are not `period_s` apart.
std::vector<BoomSample> usable_samples(std::span<const BoomMeasurement> record, const FlowConstants& flow,
                                       const BoomMachine& machine, const UsableSamples& usable = {},
                                       double period_s = sampling_period_s);

/// The whole way: simulate the scenario, measure it with noise, take the usable samples, as plain numbers in
/// the order of BoomSample.
std::vector<std::vector<double>> boom_record(const BoomScenario& scenario, const MeasurementNoise& noise,
                                             const UniformSource& uniform, const UsableSamples& usable = {});

} // namespace placedpar
