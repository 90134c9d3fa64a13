#pragma once

#include "report/search_log.hpp"

#include <boost/json/fwd.hpp>

#include <span>
#include <string>

namespace placedpar {

// These functions print the part of a run's report about the generations of each search, and of all searches together.
// They leave out a search without generations.

/// Prints the searches of one run for people: first and last generation, diversity at the end, and how many immigrants
/// were accepted and turned away.
std::string print_searches(const GenerationLog&);
/// Prints the searches of runs with several seeds: medians, and quartiles in brackets. REQUIRES: at least one log; all
/// logs are of one network.
std::string print_searches(std::span<const SeededLog>);

/// Returns the searches for programs: an array, whose last element, `all`, is about all searches together.
boost::json::array searches_json(const GenerationLog&);

} // namespace placedpar
