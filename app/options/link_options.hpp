#pragma once

#include "app/options.hpp"

#include <string>

namespace placedpar {

/// Declares --link: links of an excavator by name or symbol, separated by commas.
Option add_links(Options&, std::string& links, const std::string& about);

/// Declares --configuration: the configuration of the excavator's main valve, a to e.
Option add_configuration(Options&, std::string& configuration, const std::string& about);

} // namespace placedpar
