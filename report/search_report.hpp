#pragma once

#include "report/search_log.hpp"

#include <boost/json/fwd.hpp>

#include <span>
#include <string>

namespace placedpar {

// What a report says of the generations of searches, of each and of all together; nothing of a search without any.

/// For people, of one run: first and last generation, diversity at the end, and what became of immigrants.
std::string print_searches(const GenerationLog&);
/// Of runs with several seeds: medians, and in brackets quartiles. REQUIRES: logs of one network, one at least.
std::string print_searches(std::span<const SeededLog>);

/// For machines: an array, `all` at the end.
boost::json::array searches_json(const GenerationLog&);

} // namespace placedpar
