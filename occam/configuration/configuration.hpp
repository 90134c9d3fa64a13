#pragma once

#include "netlist/language/made_netlist.hpp"

#include <filesystem>

namespace placedpar::occam {

/// Returns whether a file describes processors and what they execute: its name ends in .pgm, or in .occ and a PLACED
/// PAR stands at its outermost level.
bool is_configuration(const SourceFile&);
/// Does the same for a path. Returns false for a file that cannot be read.
bool is_configuration(const std::filesystem::path&);

/// Makes a netlist of a configuration (docs/reference/occam.md). Returns no text for another file, or after
/// reporting errors. Folders are searched for the files that #INCLUDE and #USE name. A VAL outside of all parts gets
/// the chosen value; the code of PROCs keeps the value of the text.
MadeNetlist netlist_of_configuration(const std::shared_ptr<const SourceFile>&,
                                     const std::vector<std::filesystem::path>& folders, const ValChoice&, Reporter&);

} // namespace placedpar::occam
