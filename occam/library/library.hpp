#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar::occam {

/// Returns the text of a library or a file of constants that is built into PlacedPar; nothing if none has this name.
/// `name` is a name in #USE or #INCLUDE, such as "hostio.lib" or "hostio.inc". The extension ".inc" means a file of
/// constants. Any other name means a library: "hostio", "hostio.tco", "course.module". REQUIRES: the name has no path
/// and no capital letters.
std::optional<std::string> library_text(std::string_view name);

/// Returns the names of the libraries and files, such as "hostio.lib", in alphabetical order, for hints and completion.
std::vector<std::string> library_names();

} // namespace placedpar::occam
