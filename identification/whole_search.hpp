#pragma once

#include "identification/compliance_search.hpp"
#include "identification/identification.hpp"
#include "identification/identification_way.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace placedpar::identification {

/// The settings of a search for several compliances over a whole movement. `way.search.window.trials` is the number of
/// generations of a round. After each round new FlowWeights are computed from the scatter of the missing flows at the
/// best individual (flow_weights.hpp). The first round uses the error of equation 3.11.
struct WholeWay {
    IdentificationWay way;
    std::size_t rounds = 6;
};

/// Returns the settings for this number of links, chosen on seeds 1001 to 1040 of simulated machines: Gray code, an
/// elite of 2, 12 bits for each compliance, and more individuals for more links. On an outlet side the search uses only
/// the samples of the transient: later pressures contain little information about C_o, and their noise shifts the
/// answer.
WholeWay whole_way(std::size_t links, hydraulics::Side side = hydraulics::Side::inlet);

/// Flags a link whose answer may differ by more than 10 % from LinkIdentified::of_all_samples, counting three standard
/// errors. Noise in the readings also shifts the answer, which two standard errors would not cover.
void flag_limit(LinkIdentified& link);

/// Identifies the compliances from all samples together. LinkIdentified::standard_error and of_all_samples come from
/// weighted least squares; the standard error is the least that the record's noise allows (the Cramer-Rao bound). Uses
/// at most the first 1,024 samples (exact_fitness_terms). Throws UnfitRecord if there are fewer samples than the first
/// generation needs.
Identified identify_whole(const ComplianceSearch& prepared, const WholeWay& whole, std::uint64_t seed);

/// The work of a search, and its time on T800s of 20 MHz.
struct SearchCost {
    /// The number of individuals evaluated, and of errors computed. Each error is the error of one individual at one
    /// sample.
    double individuals, errors;
    double seconds, seconds_on_16; ///< time on one T800, and on the 16 T800s of Figure E.2 without communication
};

/// Returns the cost by Table E.1: 1,440 cycles for the error of one junction at one sample, and 1,750 cycles for the
/// genetic operators on 10 bits. All 16 T800s evaluate, and four masters each breed a quarter of the population.
SearchCost cost_of(const WholeWay& whole, const CircuitProblem& problem, std::uint64_t generations,
                   std::size_t samples);

} // namespace placedpar::identification
