#pragma once

#include "gaprocs/initial_population.hpp" // for SearchSettings::initial
#include "gaprocs/search_problem.hpp"
#include "gaprocs/settings.hpp"
#include "gaprocs/spread_population.hpp" // for SearchSettings::initial

#include <cstddef>
#include <span>
#include <vector>

namespace placedpar {

/// The settings for a problem unless others are given: the thesis's, but for reproduction by ranking where the
/// problem has an objective, which may be negative, and for the operators of other than binary strings: blend crossover
/// and gaussian mutation of real vectors, order crossover and inversion of permutations.
SearchSettings usual_settings(const SearchProblem&);

/// Returns the settings adapted to the problem. Window and generations per sample only matter with a record: with an
/// objective they become one empty sample and one generation. Throws UserError for settings that do not fit the
/// problem: see require_fitting_reproduction() and require_fitting_operators().
SearchSettings settings_for(const SearchProblem&, SearchSettings settings);

/// Throws UserError, saying what would be right, for a reproduction by which no individual could become a parent: one
/// that needs positive fitness, with an objective that is minimised and therefore negated.
void require_fitting_reproduction(const SearchProblem&, const Reproduction&);

/// Throws std::invalid_argument for a sample whose number of values is not the problem's number of channels.
void require_channels(const SearchProblem&, std::span<const Sample> record);

/// Returns the record of an objective problem for a number of generations: samples without a number. Throws UserError
/// for none.
std::vector<Sample> empty_record(std::size_t generations);

} // namespace placedpar
