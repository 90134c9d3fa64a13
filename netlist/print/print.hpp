#pragma once

#include "netlist/network/network.hpp"

#include <cstdint>
#include <string>
#include <string_view>

namespace placedpar {

/// In the netlist language: loads again to the same network. Parameters come in the order in which the netlist gives
/// them, and the toolset's include stands before what it declares, so that the real tool takes it, too.
std::string print_cfs(const Network& network);
/// The same network has the same, whatever the order of its parameters, and with or without the include.
std::string canonical_form(const Network& network);
/// For Graphviz: processors as boxes with their processes, wires labelled with their links.
std::string print_dot(const Network& network);
/// One JSON document with keys in a fixed order; ends with a newline.
std::string print_json(const Network& network);

/// FNV-1a, 64 bits, of the canonical form.
std::uint64_t network_hash(std::string_view canonical);

} // namespace placedpar
