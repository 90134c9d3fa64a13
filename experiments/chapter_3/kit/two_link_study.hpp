#pragma once

#include "hydraulics/plant/excavator_motion.hpp"
#include "hydraulics/plant/measurement.hpp"
#include "identification/compliance_search.hpp"
#include "identification/transient_search.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace placedpar {

/// Bucket and boom, simulated once (scenario R2, Figure 3.9).
struct TwoLinkMotion {
    hydraulics::ExcavatorScenario scenario;
    hydraulics::ExcavatorMotion motion;
    hydraulics::LinkCalibrations calibrations;
};
TwoLinkMotion simulate_two_links();

/// The record of it that a seed's sensors write, and what identification uses of that.
identification::ComplianceSearch measure_two_links(const TwoLinkMotion& motion,
                                                   const hydraulics::MeasurementNoise& noise,
                                                   const identification::IdentificationWay& way, std::uint64_t seed);

/// Errors of the two compliances, in percent without sign.
struct TwoErrors {
    double bucket, boom;

    bool both_within(double percent) const { return bucket <= percent && boom <= percent; }
};
TwoErrors errors_of(std::span<const double> compliance_in3_per_psi);

/// What 3.2 describes, made surer: one elite, and the first two samples after the valve opens left out.
identification::IdentificationWay elite_way();
/// That, and Gray code.
identification::IdentificationWay gray_way();

/// Records that a judged share is counted over: one of p scatters by sqrt(p (1 - p) / 200), 3.5 points at one half.
inline constexpr std::size_t search_records = 200;

/// Many searches, each with noise and random numbers of its own.
std::vector<identification::SearchRun> search_many(const TwoLinkMotion& motion,
                                                   const hydraulics::MeasurementNoise& noise,
                                                   const identification::IdentificationWay& way,
                                                   std::span<const std::uint64_t> seeds);

/// The share of searches in percent in which both are within 10 % after the given generation.
double both_within_ten_percent(std::span<const identification::SearchRun> runs, std::size_t generation,
                               std::size_t trials);

/// Pressures at the junctions and all flows at one instant: P_11, P_12 in psi, Q_11, Q_12, Q_BUi, Q_BOi in in^3/s.
struct InternalStates {
    double p11, p12, q11, q12, q_bucket, q_boom;

    static constexpr std::size_t count = 6;
    std::array<double, count> values() const { return {p11, p12, q11, q12, q_bucket, q_boom}; }
};
InternalStates true_states(const hydraulics::ExcavatorState& state);
/// What compliances make of a sample, as the thesis records it of the best individual (3.2, step 7).
InternalStates estimated_states(const hydraulics::CircuitSample& sample, std::span<const double> compliance_in3_per_psi,
                                const hydraulics::FlowConstants& flow);

} // namespace placedpar
