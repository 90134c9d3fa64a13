#pragma once

#include "gaprocs/initial_population.hpp" // for SearchSettings::initial
#include "gaprocs/search_problem.hpp"
#include "gaprocs/settings.hpp"
#include "gaprocs/spread_population.hpp" // for SearchSettings::initial

#include <cstddef>
#include <span>
#include <vector>

namespace placedpar {

/// Returns the settings that a search of this problem has unless others are given. They are the thesis's settings, with
/// two exceptions. For an objective, which may be negative, reproduction is by ranking. Real vectors have blend
/// crossover and gaussian mutation; permutations have order crossover and inversion.
SearchSettings usual_settings(const SearchProblem&);

/// Returns the settings adapted to the problem. The window and the generations per sample only matter with a record;
/// for an objective they become one empty sample and one generation. Throws UserError for settings that do not fit the
/// problem: see require_fitting_reproduction() and require_fitting_operators().
SearchSettings settings_for(const SearchProblem&, SearchSettings settings);

/// Throws UserError, with what would be right, if no individual could become a parent. This is so if the reproduction
/// needs positive fitness, and the objective is minimised and therefore negated.
void require_fitting_reproduction(const SearchProblem&, const Reproduction&);

/// Throws std::invalid_argument if a sample does not have one value for each channel of the problem.
void require_channels(const SearchProblem&, std::span<const Sample> record);

/// Returns the record of an objective problem: one sample without numbers for each generation. Throws UserError for 0
/// generations.
std::vector<Sample> empty_record(std::size_t generations);

} // namespace placedpar
