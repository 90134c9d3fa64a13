#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar::occam {

/// Returns the text of one of PlacedPar's libraries or files of constants, by its name in #USE or #INCLUDE:
/// "hostio.lib", "hostio.inc". The name has small letters and no path. Nothing if there is none. Any extension but
/// ".inc" names a library: "hostio.tco", "hostio.occ", "course.module"; so does a name without one.
std::optional<std::string> library_text(std::string_view name);

/// Returns the names that a message can propose, such as "hostio.lib", in alphabetic order.
std::vector<std::string> library_names();

} // namespace placedpar::occam
