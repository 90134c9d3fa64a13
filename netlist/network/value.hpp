#pragma once

#include <cstdint>
#include <string>
#include <variant>

namespace placedpar {

/// Holds the value of a parameter or an attribute after elaboration: the value in the netlist, or the kind's default
/// value. TRUE and FALSE are the integers 1 and 0, as in the configuration language.
using Value = std::variant<std::int64_t, double, std::string>;

} // namespace placedpar
