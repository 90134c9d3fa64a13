#include "hydraulics/boom_record.hpp"

#include "hydraulics/boom_orifices.hpp"
#include "hydraulics/flow_split.hpp"
#include "hydraulics/line_fit.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace placedpar {

namespace {

/// One sensor's readings.
std::vector<double> readings(std::span<const BoomMeasurement> record, double BoomMeasurement::*sensor) {
    std::vector<double> values;
    values.reserve(record.size());
    for (const BoomMeasurement& measurement : record)
        values.push_back(measurement.*sensor);
    return values;
}

void require_period(std::span<const BoomMeasurement> record, double period_s) {
    for (std::size_t i = 1; i < record.size(); ++i)
        if (double gap = record[i].time_s - record[i - 1].time_s; std::abs(gap - period_s) > 1e-6 * period_s)
            throw std::invalid_argument(
                fmt::format("measurements {} and {} are {} s apart, expected {} s", i - 1, i, gap, period_s));
}

/// By how much the pump would exceed the cylinder's pressure if nothing flowed in.
double open_by_psi(const BoomSample& sample, const FlowConstants& flow) {
    return bypass_only_psi(sample.bypass_in2, flow) - sample.inlet_psi;
}

} // namespace

std::vector<BoomSample> usable_samples(std::span<const BoomMeasurement> record, const FlowConstants& flow,
                                       const BoomMachine& machine, const UsableSamples& usable, double period_s) {
    require_period(record, period_s);
    CentredLineFit fit(period_s);
    std::vector<double> pressure = readings(record, &BoomMeasurement::inlet_psi);
    std::vector<double> angle = readings(record, &BoomMeasurement::angle_deg);
    double piston_flow_per_deg = machine.inlet_area_in2 * machine.moment_arm_in * std::numbers::pi / 180;
    std::vector<BoomSample> samples;
    for (std::size_t i = 0; i < record.size() && samples.size() < usable.count; ++i) {
        if (!CentredLineFit::has_slope(record.size(), i))
            continue;
        OrificeAreas areas = boom_orifices(record[i].spool_in);
        BoomSample sample{pressure[i], fit.slope_per_s(pressure, i), piston_flow_per_deg * fit.slope_per_s(angle, i),
                          areas.inlet_in2, areas.bypass_in2};
        double open = open_by_psi(sample, flow);
        bool first = samples.empty();
        if (areas.inlet_in2 <= 0 || open <= (first ? usable.open_by_psi : 0))
            continue;
        if (first && sample.inlet_slope_psi_per_s <= usable.first_slope_psi_per_s)
            continue;
        samples.push_back(sample);
    }
    return samples;
}

std::vector<std::vector<double>> boom_record(const BoomScenario& scenario, const MeasurementNoise& noise,
                                             const UniformSource& uniform, const UsableSamples& usable) {
    std::vector<BoomState> motion = simulate_boom(scenario);
    std::vector<BoomMeasurement> measured =
        measure_boom(motion, scenario.machine.moment_arm_in, sampling_period_s, noise, uniform);
    std::vector<std::vector<double>> record;
    for (const BoomSample& sample : usable_samples(measured, scenario.flow, scenario.machine, usable))
        record.push_back(sample.values());
    return record;
}

} // namespace placedpar
