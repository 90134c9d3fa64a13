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

inline constexpr std::uint64_t hash_of_nothing = 0xcbf29ce484222325U; ///< offset of FNV-1a, 64 bits

/// FNV-1a, 64 bits, of the canonical form; of a text in pieces, `before` is the hash of the piece before.
std::uint64_t network_hash(std::string_view canonical, std::uint64_t before = hash_of_nothing);

/// A network in both of its forms, of which the longer parts are printed once.
struct WrittenOut {
    std::string text = "";  ///< print_cfs; "" if it is too large
    std::size_t bytes = 0;  ///< of print_cfs
    std::uint64_t hash = 0; ///< of the canonical form; 0 if it is too large
};
/// Of what has more bytes, only the number of them is found, without printing it.
WrittenOut write_out(const Network& network, std::size_t most_bytes);

} // namespace placedpar
