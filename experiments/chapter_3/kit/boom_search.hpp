#pragma once

#include "experiments/chapter_3/kit/boom_data.hpp"
#include "identification/identification.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace placedpar {

/// The result of an identification, that is, of the search for the boom's compliance in a record of a motion.
struct BoomIdentified {
    std::vector<hydraulics::CircuitSample> samples; ///< only the usable samples
    identification::Identified found;
    double compliance_in3_per_psi;       ///< the search's answer
    std::optional<double> least_squares; ///< compliance by a least-squares fit to all usable samples; may be negative,
                                         ///< like the first value in the thesis
    bool at_lower_bound;                 ///< whether the answer is at the lower bound of the search
};

/// Returns the samples that the rule UsableSamples selects: samples from which a compliance can be found.
std::vector<hydraulics::CircuitSample> usable_of(const BoomData&, const BoomModel&, const hydraulics::UsableSamples&);

/// Identifies the boom's compliance from the record. Throws what identify() throws.
BoomIdentified identify_boom(const BoomData&, const BoomModel&, const identification::IdentificationWay&,
                             std::uint64_t seed);

/// Returns the compliance from a least-squares fit to all usable samples; it may be negative. Returns nullopt if there
/// are fewer than 5 samples or the fit does not converge.
std::optional<double> least_squares_compliance(const BoomData&, const BoomModel&,
                                               const hydraulics::UsableSamples& = {});

struct Generation {
    double time_s; ///< time of the newest sample
    double best_in3_per_psi;
    double best_error_in3_per_s; ///< rms over the window, for the best individual
    double mean_error_in3_per_s; ///< mean absolute error over all individuals and the window
};

/// Repeats the search of identify_boom() and returns its generations, for a plot.
std::vector<Generation> watch_search(const BoomData&, std::span<const hydraulics::CircuitSample> samples,
                                     const identification::IdentificationWay&, std::uint64_t seed);

} // namespace placedpar
