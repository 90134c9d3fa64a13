#pragma once

#include "netlist/network/network.hpp"

#include <cstdint>
#include <string>
#include <string_view>

namespace placedpar {

/// Prints the network in the netlist language; the text reads back to the same network. Parameters keep the order of
/// the netlist, and the toolset's include comes before the first use of its declarations, so INMOS's configurer icconf
/// also accepts the text.
std::string print_cfs(const Network& network);
/// Returns the text that is hashed. Neither the order of parameters nor the toolset's include changes this text.
std::string canonical_form(const Network& network);
/// Prints the network for Graphviz: processors as boxes with their processes, wires labelled with their links.
std::string print_dot(const Network& network);
/// Prints one JSON document with keys in a fixed order and a newline at the end.
std::string print_json(const Network& network);

inline constexpr std::uint64_t hash_of_nothing = 0xcbf29ce484222325U; ///< offset of FNV-1a, 64 bits

/// Returns the FNV-1a hash, 64 bits, of the canonical form. To hash a text in pieces, pass the hash of the preceding
/// pieces as `before`.
std::uint64_t network_hash(std::string_view canonical, std::uint64_t before = hash_of_nothing);

/// Returns the FNV-1a hash of the contents of a node's bootable file. REQUIRES: the node has one.
std::uint64_t boot_hash(const Node& node);

/// Holds the printed form of a network and the hash of its canonical form. The long parts are equal in the two forms,
/// and are printed only once.
struct WrittenOut {
    std::string text = "";  ///< print_cfs; "" if it is too large
    std::size_t bytes = 0;  ///< length of print_cfs()
    std::uint64_t hash = 0; ///< hash of the canonical form; 0 if the text is too large
};
/// Prints the network. If the text has more than `most_bytes`, only counts its bytes.
WrittenOut write_out(const Network& network, std::size_t most_bytes);

} // namespace placedpar
