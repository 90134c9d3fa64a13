#pragma once

#include "hydraulics/plant/excavator_record.hpp"
#include "hydraulics/plant/excavator_values.hpp"
#include "identification/compliance_search.hpp"
#include "identification/identification.hpp"
#include "runtime/random.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace placedpar {

/// Returns a measured record of scenario A; each seed gives another record.
inline hydraulics::Record boom_measured(double duration_s, const hydraulics::MeasurementNoise& noise,
                                        std::uint64_t seed, double true_compliance = 0.0086) {
    hydraulics::ExcavatorScenario scenario = hydraulics::single_boom_scenario();
    scenario.duration_s = duration_s;
    scenario.links[0].mechanics.inlet_compliance_in3_per_psi = true_compliance;
    RandomStream sensors(seed, "sensors");
    return measure_excavator(simulate_excavator(scenario), scenario, hydraulics::sampling_period_s, noise,
                             [&] { return sensors.uniform(); });
}

inline identification::Identified identify_boom(const hydraulics::Record& record,
                                                const identification::IdentificationWay& way, std::uint64_t seed,
                                                std::optional<double> spool_offset_in = {}) {
    identification::ComplianceSearch prepared =
        identification::prepare(record, hydraulics::Parameters::excavator(),
                                {hydraulics::Configuration::a, {hydraulics::Link::boom}, spool_offset_in}, way);
    return identification::identify(prepared.problem, prepared.flow, prepared.samples, way, seed);
}

inline double error_percent(double compliance, double truth) { return 100 * std::abs(compliance / truth - 1); }

} // namespace placedpar
