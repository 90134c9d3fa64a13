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

/// A simulated motion of bucket and boom (scenario R2, Figure 3.9).
struct TwoLinkMotion {
    hydraulics::ExcavatorScenario scenario;
    hydraulics::ExcavatorMotion motion;
    hydraulics::LinkCalibrations calibrations;
};
TwoLinkMotion simulate_two_links();

/// Measures the motion with sensor noise that is drawn from the seed, and prepares the search for the two compliances.
identification::ComplianceSearch measure_two_links(const TwoLinkMotion& motion,
                                                   const hydraulics::MeasurementNoise& noise,
                                                   const identification::IdentificationWay& way, std::uint64_t seed);

/// The absolute errors of the two compliances, as percentages of the true values.
struct TwoErrors {
    double bucket, boom;

    bool both_within(double percent) const { return bucket <= percent && boom <= percent; }
};
TwoErrors errors_of(std::span<const double> compliance_in3_per_psi);

/// Returns the settings of section 3.2 of the thesis with two changes: there is one elite individual, and the first two
/// samples after the valve opens are left out.
identification::IdentificationWay elite_way();
/// Returns elite_way() with Gray code.
identification::IdentificationWay gray_way();

/// The number of simulated records. Each record is searched once, and a given share of the searches must succeed. With
/// 200 records, a measured share p has the standard deviation sqrt(p (1 - p) / 200): 3.5 percentage points for p = .5.
inline constexpr std::size_t search_records = 200;

/// A record of bucket and boom, prepared for a search, and the generations of the search.
struct TwoLinkSearch {
    identification::ComplianceSearch prepared;
    identification::SearchRun run;
};
/// Measures and searches one record. The seed determines the noise of the record and the random numbers of the search.
TwoLinkSearch search_two_links(const TwoLinkMotion& motion, const hydraulics::MeasurementNoise& noise,
                               const identification::IdentificationWay& way, std::uint64_t seed);
/// Runs search_two_links() with each seed.
std::vector<identification::SearchRun> search_many(const TwoLinkMotion& motion,
                                                   const hydraulics::MeasurementNoise& noise,
                                                   const identification::IdentificationWay& way,
                                                   std::span<const std::uint64_t> seeds);

/// Returns the percentage of searches in which both errors are at most 10 % after this generation. A search with fewer
/// generations is judged at its end.
double both_within_ten_percent(std::span<const identification::SearchRun> runs, std::size_t generation,
                               std::size_t trials);

/// The pressures at the junctions and all flows at one instant: P_11 and P_12 in psi, Q_11, Q_12, Q_BUi (bucket) and
/// Q_BOi (boom) in in^3/s.
struct InternalStates {
    double p11, p12, q11, q12, q_bucket, q_boom;

    static constexpr std::size_t count = 6;
    std::array<double, count> values() const { return {p11, p12, q11, q12, q_bucket, q_boom}; }
};
InternalStates true_states(const hydraulics::ExcavatorState& state);
/// Returns the states computed from a sample and the given compliances. The thesis records these states for the best
/// individual (3.2, step 7).
InternalStates estimated_states(const hydraulics::CircuitSample& sample, std::span<const double> compliance_in3_per_psi,
                                const hydraulics::FlowConstants& flow);

} // namespace placedpar
