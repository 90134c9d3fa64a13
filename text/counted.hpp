#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace placedpar {

/// Returns "1 process", "2 processes". If `more` is empty, the plural is `one` with an "s": "2 wires".
std::string counted(std::size_t count, std::string_view one, std::string_view more = "");
/// Returns "1 byte", "2 bytes", "1 ms", "1.5". The unit is given in the plural: for the value 1, a unit of at least
/// four letters loses its "s". "" means no unit.
std::string with_unit(double value, std::string_view unit);
/// Returns "a channel", "an input", according to the noun's first letter, which must be in lower case.
std::string with_article(std::string_view noun);

} // namespace placedpar
