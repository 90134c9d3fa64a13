#pragma once

#include "experiments/chapter_3/kit/boom_data.hpp"
#include "identification/identification.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace placedpar {

/// What is identified from data with a model, by the thesis's way or another.
struct BoomIdentified {
    std::vector<hydraulics::CircuitSample> samples; ///< the usable ones
    identification::Identified found;
    double compliance_in3_per_psi;       ///< the search's
    std::optional<double> least_squares; ///< of all samples; may be negative, as the thesis's first value was
    bool at_lower_bound;                 ///< flagged so
};

/// Throws as identify().
BoomIdentified identify_boom(const BoomData&, const BoomModel&, const identification::IdentificationWay&,
                             std::uint64_t seed);

/// The signed least squares of all usable samples; none when there are fewer than 5 or it does not settle.
std::optional<double> least_squares_compliance(const BoomData&, const BoomModel&,
                                               const hydraulics::UsableSamples& = {});

/// One generation of a search.
struct Generation {
    double time_s; ///< of the newest sample
    double best_in3_per_psi;
    double best_error_in3_per_s; ///< rms over the window
    double mean_error_in3_per_s; ///< of all individuals, over the window
};

/// The search of identify() again, watched: the same population by population.
std::vector<Generation> watch_search(const BoomData&, std::span<const hydraulics::CircuitSample> samples,
                                     const identification::IdentificationWay&, std::uint64_t seed);

} // namespace placedpar
