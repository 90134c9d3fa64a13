#pragma once

#include "identification/on_line/population_sets.hpp"

#include <string>

namespace placedpar::monitor {

/// Returns the symbols of the links, as stored alarms have them: "BU BO" for bucket and boom.
inline std::string words_of(hydraulics::LinkSet links) {
    std::string words;
    for (hydraulics::Link link : identification::links_of(links))
        words += (words.empty() ? "" : " ") + std::string(symbol_of(link));
    return words;
}

} // namespace placedpar::monitor
