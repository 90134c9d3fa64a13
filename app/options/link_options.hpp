#pragma once

#include "app/options.hpp"
#include "hydraulics/circuit/circuit.hpp"
#include "hydraulics/data/link.hpp"

#include <string>

namespace placedpar {

/// --link, of links by name or symbol with commas between.
Option add_links(Options&, std::string& links, const std::string& about);

/// --configuration, a to e, of the main valve.
Option add_configuration(Options&, std::string& configuration, const std::string& about);

/// What --link says. Throws UserError for a name that is not a link's, or is there twice.
hydraulics::LinkSet links_of(const std::string& links);

} // namespace placedpar
