#pragma once

#include "netlist/language/made_netlist.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar::occam {

/// Describes an attribute that SET gives to a node.
struct NodeAttribute {
    std::string name, about;
};
const std::vector<NodeAttribute>& node_attributes();
/// Returns the types that SET can give to a node.
std::span<const std::string_view> processor_types();

/// Returns whether a file is a configuration, which describes processors and their programs. The file's name ends in
/// .pgm, or it ends in .occ and the file has a PLACED PAR at its outermost level.
bool is_configuration(const SourceFile&);
/// Returns whether the file at this path is a configuration; false if the file cannot be read.
bool is_configuration(const std::filesystem::path&);

/// Makes a netlist from a configuration (docs/reference/occam.md). Returns no text if the file is not a configuration,
/// or after reporting errors. Files that #INCLUDE and #USE name are looked for in the folders. The ValChoice can
/// change a VAL that is declared outside of NETWORK, MAPPING and CONFIG; but in the code of PROCs, the VAL keeps the
/// value that the text gives it.
MadeNetlist netlist_of_configuration(const std::shared_ptr<const SourceFile>&,
                                     const std::vector<std::filesystem::path>& folders, const ValChoice&, Reporter&);

} // namespace placedpar::occam
