#pragma once

#include "app/options.hpp"

#include <string>

namespace placedpar {

/// Declares --link: links by name or symbol, separated by commas.
Option add_links(Options&, std::string& links, const std::string& about);

/// Declares --configuration, a to e, of the main valve.
Option add_configuration(Options&, std::string& configuration, const std::string& about);

} // namespace placedpar
