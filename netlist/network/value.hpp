#pragma once

#include <cstdint>
#include <string>
#include <variant>

namespace placedpar {

/// The value of a parameter or an attribute once the netlist is elaborated: what the netlist gives it, or the default
/// of its kind. TRUE and FALSE are the integers 1 and 0, as in the configuration language.
using Value = std::variant<std::int64_t, double, std::string>;

} // namespace placedpar
