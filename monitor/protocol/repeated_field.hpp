#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace placedpar::monitor {

/// The path, such as "links.BO.inlet_psi", of the first field that stands twice in one object; none when there is none.
/// A JSON parser would silently keep the last. REQUIRES: the text is JSON.
std::optional<std::string> repeated_field(std::string_view text);

} // namespace placedpar::monitor
