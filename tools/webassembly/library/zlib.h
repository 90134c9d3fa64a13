#pragma once

// The part of zlib that observe/ uses. There is no zlib for WebAssembly in Debian. The bytes are stored without being
// compressed (RFC 1950 and 1951), since the page of a run does not leave the browser.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>

using Bytef = unsigned char;
using uLong = unsigned long;
using uLongf = unsigned long;
constexpr int Z_OK = 0, Z_BUF_ERROR = -5;

namespace zlib_stored {

constexpr uLong longest_block = 65535, bytes_of_head = 5, bytes_of_frame = 6;

inline std::uint32_t adler32(const Bytef* bytes, uLong size) {
    std::uint32_t a = 1, b = 0;
    for (uLong i = 0; i < size; ++i) {
        a = (a + bytes[i]) % 65521;
        b = (b + a) % 65521;
    }
    return b << 16 | a;
}

} // namespace zlib_stored

inline uLong compressBound(uLong size) {
    using namespace zlib_stored;
    return size + bytes_of_head * (size / longest_block + 1) + bytes_of_frame;
}

inline int compress2(Bytef* to, uLongf* size_of_to, const Bytef* from, uLong size, int) {
    using namespace zlib_stored;
    if (*size_of_to < compressBound(size))
        return Z_BUF_ERROR;
    Bytef* at = to;
    *at++ = 0x78;
    *at++ = 0x01;
    const std::uint32_t sum = adler32(from, size);
    do {
        const auto length = static_cast<std::uint16_t>(std::min(size, longest_block));
        const std::uint16_t inverse = static_cast<std::uint16_t>(~length);
        const Bytef head[] = {size == length, Bytef(length & 255), Bytef(length >> 8), Bytef(inverse & 255),
                              Bytef(inverse >> 8)};
        at = std::copy(std::begin(head), std::end(head), at);
        at = std::copy_n(from, length, at);
        from += length;
        size -= length;
    } while (size > 0);
    for (int shift = 24; shift >= 0; shift -= 8)
        *at++ = Bytef(sum >> shift);
    *size_of_to = static_cast<uLongf>(at - to);
    return Z_OK;
}
