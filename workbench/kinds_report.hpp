#pragma once

#include "netlist/kinds/catalogue.hpp"

#include <string>

namespace placedpar {

/// A line for each kind.
std::string print_kinds(const Catalogue&);
/// Everything about one kind: its ports, parameters and measures.
std::string print_kind(const ProcessKind&);

} // namespace placedpar
