#pragma once

#include "netlist/network/network.hpp"

#include <cstdint>
#include <string>
#include <string_view>

namespace placedpar {

/// The canonical form in the netlist language: loads again to the same network.
std::string print_cfs(const Network& network);
/// For Graphviz: processors as boxes with their processes, wires labelled with their links.
std::string print_dot(const Network& network);
/// One JSON document with keys in a fixed order; ends with a newline.
std::string print_json(const Network& network);

/// FNV-1a, 64 bits, of what print_cfs printed.
std::uint64_t network_hash(std::string_view printed);

} // namespace placedpar
