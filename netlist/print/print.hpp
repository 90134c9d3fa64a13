#pragma once

#include "netlist/network/network.hpp"

#include <cstdint>
#include <string>
#include <string_view>

namespace placedpar {

/// Prints the network in the netlist language, so that reading the text gives the same network. INMOS's configurer
/// icconf accepts the text, too: parameters keep their order, and the include file of INMOS's toolset comes before the
/// first use of its declarations.
std::string print_cfs(const Network& network);
/// Returns a text that is equal for two netlists of the same network; its hash is Network::hash. The text does not
/// depend on the order of parameters, nor on whether the netlist includes files of the toolset.
std::string canonical_form(const Network& network);
/// Prints a drawing of the network for Graphviz. Boxes stand for processors and contain the names of their processes.
/// Wires have the numbers of their links.
std::string print_dot(const Network& network);
/// Prints the network as one JSON document, with keys in a fixed order and a newline at the end.
std::string print_json(const Network& network);

inline constexpr std::uint64_t hash_of_nothing = 0xcbf29ce484222325U; ///< initial value of the FNV-1a hash, 64 bits

/// Returns the FNV-1a hash, 64 bits, of the text of canonical_form(). To hash a text in pieces, pass the hash of the
/// preceding pieces as `before`.
std::uint64_t network_hash(std::string_view canonical, std::uint64_t before = hash_of_nothing);

/// Returns the FNV-1a hash of the contents of a node's bootable file. REQUIRES: the node has a bootable file.
std::uint64_t boot_hash(const Node& node);

/// Holds the text of print_cfs() and the hash of canonical_form(). Long parts of these two texts are equal, so that
/// printing them together is faster.
struct WrittenOut {
    std::string text = "";  ///< the text of print_cfs(); "" if it is too large
    std::size_t bytes = 0;  ///< length of print_cfs()
    std::uint64_t hash = 0; ///< hash of the canonical form; 0 if the text is too large
};
/// Prints the network. If the text of print_cfs() has more than `most_bytes`, only counts its bytes.
WrittenOut write_out(const Network& network, std::size_t most_bytes);

} // namespace placedpar
