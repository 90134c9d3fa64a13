#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace placedpar {

/// Returns a count with its noun, such as "1 process" or "2 processes". If `more` is empty, the plural is `one` with an
/// "s": "2 wires".
std::string counted(std::size_t count, std::string_view one, std::string_view more = "");
/// Returns a value with its unit, such as "1 byte", "2 bytes", "1 ms" or "1.5". The caller gives the unit in the
/// plural: for the value 1, a unit of at least four letters loses its "s". "" means no unit.
std::string with_unit(double value, std::string_view unit);
/// Returns a noun with its article, such as "a channel" or "an input". The first letter of the noun decides; it must be
/// in lower case.
std::string with_article(std::string_view noun);

} // namespace placedpar
