#pragma once

#include "netlist/language/made_netlist.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar::occam {

/// Describes an attribute that the statement SET of a configuration can give to a node.
struct NodeAttribute {
    std::string name, about;
};
const std::vector<NodeAttribute>& node_attributes();
/// Returns the types, such as "T800", that SET can give to a node.
std::span<const std::string_view> processor_types();

/// Returns whether a file in occam is a configuration, which describes processors and places processes on them. This is
/// so if the file's name ends in .pgm, or if it ends in .occ and the file has a PLACED PAR at its outermost level.
bool is_configuration(const SourceFile&);
/// Does the same for the file at this path; false if the file cannot be read.
bool is_configuration(const std::filesystem::path&);

/// Makes a netlist from a configuration (docs/reference/occam.md), so that it can be simulated. Returns no text if the
/// file is not a configuration, or after reporting errors. Searches the folders for files that #INCLUDE and #USE name.
/// The ValChoice, by which options change values, can change a VAL that is declared outside of NETWORK, MAPPING and
/// CONFIG. In the code of PROCs, such a VAL keeps the value that the text gives it.
MadeNetlist netlist_of_configuration(const std::shared_ptr<const SourceFile>&,
                                     const std::vector<std::filesystem::path>& folders, const ValChoice&, Reporter&);

} // namespace placedpar::occam
