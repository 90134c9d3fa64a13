#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace placedpar {

/// Returns a count with its noun, such as "1 process" or "2 processes". `one` is the singular, `more` the plural. If
/// `more` is empty, the plural is `one` with an "s".
std::string counted(std::size_t count, std::string_view one, std::string_view more = "");
/// Returns a value with its unit, such as "1 byte", "2 bytes", "1 ms" or "1.5". REQUIRES: the unit is in the plural, or
/// "" for none. For the value 1, the last "s" of a unit of at least four letters is left out.
std::string with_unit(double value, std::string_view unit);
/// Returns a noun with its article, such as "a channel" or "an input". The first letter decides. REQUIRES: the first
/// letter is in lower case.
std::string with_article(std::string_view noun);

} // namespace placedpar
