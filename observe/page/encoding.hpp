#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace placedpar::page {

/// Appends a number in the fewest bytes: seven bits in each byte, the lowest bits first. The highest bit is 1 in all
/// bytes except the last.
void append_number(std::string& bytes, std::uint64_t number);
/// Returns the bytes compressed in the format of zlib (RFC 1950), which browsers call "deflate".
std::string deflated(std::string_view bytes);
/// Returns the bytes in base 64 (RFC 4648).
std::string base64(std::string_view bytes);

} // namespace placedpar::page
