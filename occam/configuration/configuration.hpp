#pragma once

#include "netlist/language/made_netlist.hpp"

#include <filesystem>

namespace placedpar::occam {

/// Returns whether a file is a configuration, which describes processors and their programs. The file's name ends in
/// .pgm, or it ends in .occ and the file has a PLACED PAR at its outermost level.
bool is_configuration(const SourceFile&);
/// Does the same for a path. Returns false for a file that cannot be read.
bool is_configuration(const std::filesystem::path&);

/// Makes a netlist from a configuration (docs/reference/occam.md). Returns no text if the file is not a configuration,
/// or after reporting errors. Folders are searched for the files that #INCLUDE and #USE name. The ValChoice can change
/// a VAL outside of all parts of the configuration; in the code of PROCs, the VAL keeps its value in the text.
MadeNetlist netlist_of_configuration(const std::shared_ptr<const SourceFile>&,
                                     const std::vector<std::filesystem::path>& folders, const ValChoice&, Reporter&);

} // namespace placedpar::occam
