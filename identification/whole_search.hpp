#pragma once

#include "identification/compliance_search.hpp"
#include "identification/identification.hpp"
#include "identification/identification_way.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace placedpar::identification {

/// The settings of a search for several compliances over a whole movement. The search goes in rounds of
/// `way.search.window.trials` generations. After each round, new weights of the junctions' missing flows are computed
/// from the flows' scatter at the best individual (flow_weights.hpp). The first round has no weights and uses the error
/// of equation 3.11.
struct WholeWay {
    IdentificationWay way;
    std::size_t rounds = 6;
};

/// Returns the settings for this number of links, chosen on simulated machines: Gray code, an elite of 2, 12 bits for
/// each compliance, and more individuals for more links. For an outlet side, the search uses only the samples of the
/// transient. Later pressures say little about the outlet's compliance, and their noise shifts the answer.
WholeWay whole_way(std::size_t links, hydraulics::Side side = hydraulics::Side::inlet);

/// Flags a link if its answer's distance from LinkIdentified::of_all_samples (least squares), plus three standard
/// errors, exceeds 10 %. Two standard errors would not cover the shift of the answer that noise in the readings causes.
void flag_limit(LinkIdentified& link);

/// Identifies the compliances from all samples together. LinkIdentified::standard_error and of_all_samples come from
/// weighted least squares. The standard error is the least that the record's noise allows (the Cramer-Rao bound). Uses
/// at most the first 1,024 samples, because the sum of more fitness terms could depend on their order
/// (exact_fitness_terms). Throws UnfitRecord if there are too few samples for the first generation.
Identified identify_whole(const ComplianceSearch& prepared, const WholeWay& whole, std::uint64_t seed);

/// The work of a search, and the time that it would take on T800 transputers of 20 MHz.
struct SearchCost {
    /// The number of individuals evaluated, and of errors computed. Each error is the error of one individual at one
    /// sample.
    double individuals, errors;
    /// The times on one T800, and on the 16 T800s of Figure E.2 if communication took no time.
    double seconds, seconds_on_16;
};

/// Returns the cost by Table E.1: 1,440 cycles for the error of one junction at one sample, and 1,750 cycles for the
/// genetic operators on 10 bits of a string. All 16 T800s evaluate strings, and four of them, the masters, each breed a
/// quarter of the population.
SearchCost cost_of(const WholeWay& whole, const CircuitProblem& problem, std::uint64_t generations,
                   std::size_t samples);

} // namespace placedpar::identification
