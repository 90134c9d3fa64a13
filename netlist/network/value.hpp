#pragma once

#include <cstdint>
#include <string>
#include <variant>

namespace placedpar {

/// Holds the value of a process's parameter or a device's attribute: the value that the netlist states, or the default
/// value. TRUE and FALSE are the integers 1 and 0, as in INMOS's configuration language.
using Value = std::variant<std::int64_t, double, std::string>;

} // namespace placedpar
