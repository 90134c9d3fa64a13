#pragma once

#include "hydraulics/plant/excavator_record.hpp"
#include "hydraulics/plant/excavator_values.hpp"
#include "identification/record_problem.hpp"
#include "runtime/random.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace placedpar {

/// Scenario A measured: one record a seed.
inline hydraulics::Record boom_measured(double duration_s, const hydraulics::MeasurementNoise& noise,
                                        std::uint64_t seed, double true_compliance = 0.0086) {
    hydraulics::ExcavatorScenario scenario = hydraulics::single_boom_scenario();
    scenario.duration_s = duration_s;
    scenario.links[0].mechanics.inlet_compliance_in3_per_psi = true_compliance;
    RandomStream sensors(seed, "sensors");
    return measure_excavator(simulate_excavator(scenario), scenario, hydraulics::sampling_period_s, noise,
                             [&] { return sensors.uniform(); });
}

inline Identified identify_boom(const hydraulics::Record& record, const IdentificationWay& way, std::uint64_t seed,
                                std::optional<double> spool_offset_in = {}) {
    RecordProblem prepared = prepare(record, hydraulics::Parameters::excavator(),
                                     {hydraulics::Configuration::a, {hydraulics::Link::boom}, spool_offset_in}, way);
    return identify(prepared.problem, prepared.flow, prepared.samples, way, seed);
}

/// The value that the given share of the sample does not exceed.
inline double share_below(std::vector<double> values, double share) {
    std::sort(values.begin(), values.end());
    auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(values.size())));
    return values.at(std::max<std::size_t>(rank, 1) - 1);
}

inline double error_percent(double compliance, double truth) { return 100 * std::abs(compliance / truth - 1); }

} // namespace placedpar
