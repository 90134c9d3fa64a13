#pragma once

#include "netlist/kinds/catalogue.hpp"

#include <string>

namespace placedpar {

/// The kinds of processes and of devices, a line for each, and the names that devices are declared by.
std::string print_kinds(const Catalogue&);
/// Everything about the kind of process of this name (its ports, parameters and measures), or about what nodes can be
/// declared with by this name. Throws UserError when there is neither.
std::string print_kind(const Catalogue&, const std::string& name);

} // namespace placedpar
