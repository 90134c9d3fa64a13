#pragma once

#include "gaprocs/initial_population.hpp" // for SearchSettings::initial
#include "gaprocs/search_problem.hpp"
#include "gaprocs/settings.hpp"
#include "gaprocs/spread_population.hpp" // for SearchSettings::initial

#include <cstddef>
#include <span>
#include <vector>

namespace placedpar {

/// Returns the default settings for a problem: the settings of the thesis, with two exceptions. For an objective, which
/// may be negative, reproduction is by ranking. Real vectors are bred by blend crossover and gaussian mutation,
/// permutations by order crossover and inversion.
SearchSettings usual_settings(const SearchProblem&);

/// Returns the settings adapted to the problem. If the problem has an objective, the window has one sample and one
/// generation per sample, as empty_record() needs; otherwise the settings are unchanged. Throws what
/// require_fitting_reproduction() and require_fitting_operators() throw.
SearchSettings settings_for(const SearchProblem&, SearchSettings settings);

/// Throws a UserError that says what would be right if the objective is minimised and the reproduction needs positive
/// fitness. With a minimised objective the fitness is the negated objective. It is usually negative, so no individual
/// could become a parent.
void require_fitting_reproduction(const SearchProblem&, const Reproduction&);

/// Throws std::invalid_argument unless each sample has problem.channels() numbers.
void require_channels(const SearchProblem&, std::span<const Sample> record);

/// Returns a record for a problem with an objective: one sample without numbers for each generation. Throws UserError
/// for 0 generations.
std::vector<Sample> empty_record(std::size_t generations);

} // namespace placedpar
