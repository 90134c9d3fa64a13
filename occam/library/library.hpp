#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar::occam {

/// Returns the text of one of PlacedPar's libraries or files of constants; nothing if there is none of this name.
/// `name` is a name in #USE or #INCLUDE, such as "hostio.lib" or "hostio.inc", in small letters and without a path. A
/// name without an extension, or with any extension other than ".inc", names a library: "hostio", "hostio.tco",
/// "course.module".
std::optional<std::string> library_text(std::string_view name);

/// Returns the names that a message can suggest, such as "hostio.lib", in alphabetical order.
std::vector<std::string> library_names();

} // namespace placedpar::occam
