#pragma once

#include "hydraulics/circuit/circuit.hpp"
#include "hydraulics/data/link.hpp"

#include <string>

namespace CLI {
class App;
class Option;
} // namespace CLI

namespace placedpar {

/// --link, of links by name or symbol with commas between.
CLI::Option* add_links(CLI::App&, std::string& links, const std::string& about);

/// --configuration, a to e, of the main valve.
CLI::Option* add_configuration(CLI::App&, std::string& configuration, const std::string& about);

/// What --link says. Throws UserError for a name that is no link's, or is there twice.
hydraulics::LinkSet links_of(const std::string& links);

} // namespace placedpar
