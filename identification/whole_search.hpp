#pragma once

#include "identification/compliance_search.hpp"
#include "identification/identification.hpp"
#include "identification/identification_way.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace placedpar::identification {

/// The settings of a search for several compliances at once over a whole movement. IdentificationWay::search.window
/// .trials is the number of generations of a round. After each round the missing flows are weighed by their scatter at
/// the best individual (flow_weights.hpp). The first round uses the error of equation 3.11.
struct WholeWay {
    IdentificationWay way;
    std::size_t rounds = 6;
};

/// Returns the settings for this number of links, chosen on seeds 1001 to 1040 of simulated machines: Gray code, an
/// elite of 2, 12 bits for each compliance, and more individuals for more links. On an outlet side the search uses only
/// the samples of the transient: afterwards the pressure says little of C_o, and its noise shifts the answer.
WholeWay whole_way(std::size_t links, hydraulics::Side side = hydraulics::Side::inlet);

/// Flags a link whose answer may be off by more than 10 % within three standard errors of `of_all_samples`. Readings
/// with noise also shift the answer, which two standard errors do not cover.
void flag_limit(LinkIdentified& link);

/// Identifies the compliances from all samples at once. LinkIdentified::standard_error and of_all_samples are those of
/// weighed least squares, the limit that the record's noise leaves (Cramer-Rao). Uses at most 1,024 samples, to which a
/// fitness is limited. Throws UnfitRecord if there are fewer samples than a first generation needs.
Identified identify_whole(const ComplianceSearch& prepared, const WholeWay& whole, std::uint64_t seed);

/// The work of a search, and its time on T800s of 20 MHz.
struct SearchCost {
    double individuals, errors;    ///< evaluated individuals, and their errors at one sample
    double seconds, seconds_on_16; ///< on one T800, and on the 16 of Figure E.2 without communication
};

/// Returns the cost by Table E.1: 1,440 cycles for an error of one junction, 1,750 for the operators on 10 bits. On 16
/// T800s all evaluate, and four masters breed a quarter of the population each.
SearchCost cost_of(const WholeWay& whole, const CircuitProblem& problem, std::uint64_t generations,
                   std::size_t samples);

} // namespace placedpar::identification
