#pragma once

#include "gaprocs/initial_population.hpp" // for SearchSettings::initial
#include "gaprocs/search_problem.hpp"
#include "gaprocs/settings.hpp"
#include "gaprocs/spread_population.hpp" // for SearchSettings::initial

#include <cstddef>
#include <span>
#include <vector>

namespace placedpar {

/// Returns the default settings for a problem: the settings of the thesis, with two exceptions. For a problem with an
/// objective, whose fitness may be negative, selection is by ranking. Real vectors are bred by blend crossover and
/// gaussian mutation, permutations by order crossover and inversion.
SearchSettings usual_settings(const SearchProblem&);

/// Returns the settings adapted to the problem. A problem with an objective needs no measurements, so it gets a window
/// of one sample, and one generation per sample, for the samples of empty_record(). Otherwise the settings are
/// unchanged. Throws what require_fitting_reproduction() and require_fitting_operators() throw.
SearchSettings settings_for(const SearchProblem&, SearchSettings settings);

/// If the objective is minimised and the reproduction needs positive fitness, throws a UserError that says what would
/// be right. The fitness is then the negated objective. It is usually negative, so no individual could become a parent.
void require_fitting_reproduction(const SearchProblem&, const Reproduction&);

/// Throws std::invalid_argument unless each sample has problem.channels() numbers.
void require_channels(const SearchProblem&, std::span<const Sample> record);

/// Returns a record for a problem with an objective: one sample without numbers for each generation. With such a
/// record, searches treat all problems alike. Throws UserError for 0 generations.
std::vector<Sample> empty_record(std::size_t generations);

} // namespace placedpar
