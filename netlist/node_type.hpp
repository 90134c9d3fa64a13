#pragma once

#include "netlist/network.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar {

/// A type that nodes can be declared with, its attributes preset.
struct NodeType {
    Node preset;             ///< name empty
    int links = 4;           ///< link[0] to link[links - 1]
    std::string refusal;     ///< not empty: known, but cannot be declared, and why
    bool needs_type = false; ///< `processor` itself, which needs the attribute `type`
};

/// A workstation's links are as many as are used, up to this.
inline constexpr int most_workstation_links = 1 << 20;

/// The transputers by name in upper and lower case, TRAM modules by B-number, and `processor`, `edge`,
/// `workstation`, `C004`. Null where there is none.
///
/// Bytes of memory of a bare transputer are those on its chip. TRAMs: INMOS part numbers, as `trams.inc`
/// names them; the memory is that of the module.
const NodeType* predefined_node_type(std::string_view name);
std::vector<std::string> predefined_node_type_names();

} // namespace placedpar
