#pragma once

#include "gaprocs/front_search.hpp"
#include "picture/plot.hpp"

#include <string>

namespace placedpar {

/// Prints the front as comma-separated values: a row for each individual, with its objectives and its parameters, or
/// its string if it does not code numbers.
std::string front_csv(const SearchProblem&, const FrontResult&);

/// Draws the second objective over the first. Throws UserError if there are not two objectives, or if the front is
/// empty.
Plot front_plot(std::string title, const SearchProblem&, const FrontResult&);

/// Throws UserError unless the problem has two objectives.
void require_two_objectives(const SearchProblem&);

} // namespace placedpar
