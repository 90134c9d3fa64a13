#pragma once

#include "netlist/read.hpp"

#include <filesystem>
#include <string>

namespace placedpar {

struct CheckedFile; // explore/check/check_file.hpp

/// Reads and checks a netlist or a configuration.
CheckedFile check_netlist(const std::filesystem::path&, const Catalogue&, const Overrides& set, const ReadOptions&);
/// Reads and checks a study (a file that describes many runs of a netlist), and its netlist with the settings of the
/// first run.
CheckedFile check_study(const std::filesystem::path&, const Catalogue&);

/// Returns an error about a whole file, without a line.
Diagnostic fault_of_whole(const std::filesystem::path&, std::string message, std::string hint = "");

} // namespace placedpar
