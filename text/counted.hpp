#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace placedpar {

/// "1 process", "2 processes"; without a plural of its own, "2 wires".
std::string counted(std::size_t count, std::string_view one, std::string_view more = "");

} // namespace placedpar
