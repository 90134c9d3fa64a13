#pragma once

#include "identification/compliance_search.hpp"
#include "identification/identification.hpp"
#include "identification/identification_way.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace placedpar::identification {

/// The settings of a search for several compliances over a whole movement. `way.search.window.trials` is the number of
/// generations of a round. After each round the missing flows are weighed by their scatter at the best individual
/// (flow_weights.hpp). The first round uses the error of equation 3.11.
struct WholeWay {
    IdentificationWay way;
    std::size_t rounds = 6;
};

/// Returns the settings for this number of links, chosen on seeds 1001 to 1040 of simulated machines: Gray code, an
/// elite of 2, 12 bits for each compliance, and more individuals for more links. On an outlet side the search uses only
/// the samples of the transient: later pressures contain little information about C_o, and their noise shifts the
/// answer.
WholeWay whole_way(std::size_t links, hydraulics::Side side = hydraulics::Side::inlet);

/// Identifies the compliances from all samples together. LinkIdentified::standard_error and of_all_samples are results
/// of weighed least squares: the least error that the record's noise allows (the Cramer-Rao bound). Uses at most
/// exact_fitness_terms samples (1,024). Throws UnfitRecord if there are fewer samples than the first generation needs.
Identified identify_whole(const ComplianceSearch& prepared, const WholeWay& whole, std::uint64_t seed);

/// The work of a search, and its time on T800s of 20 MHz.
struct SearchCost {
    /// The numbers of evaluated individuals and of errors; an error is of one individual at one sample.
    double individuals, errors;
    double seconds, seconds_on_16; ///< on one T800, and on the 16 of Figure E.2 without communication
};

/// Returns the cost by Table E.1: 1,440 cycles for an error of one junction, 1,750 for the operators on 10 bits. All of
/// the 16 T800s evaluate, and four masters each breed a quarter of the population.
SearchCost cost_of(const WholeWay& whole, const CircuitProblem& problem, std::uint64_t generations,
                   std::size_t samples);

} // namespace placedpar::identification
