#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace placedpar::page {

/// Appends a number in as many bytes as it needs: seven bits in each, the lowest first, and in all but the last one the
/// highest bit set.
void append_number(std::string& bytes, std::uint64_t number);
/// Compressed in the format of zlib (RFC 1950), which browsers call "deflate".
std::string deflated(std::string_view bytes);
/// As text (RFC 4648).
std::string base64(std::string_view bytes);

} // namespace placedpar::page
