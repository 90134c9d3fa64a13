#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace placedpar::monitor {

/// The path, such as "links.BO.inlet_psi", of the first field that stands twice in one object, of which a JSON parser
/// would keep the last in silence; none when there is none. REQUIRES: the text is JSON.
std::optional<std::string> repeated_field(std::string_view text);

} // namespace placedpar::monitor
