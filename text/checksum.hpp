#pragma once

#include <boost/crc.hpp>

#include <cstdint>
#include <string_view>

namespace placedpar {

/// Returns the CRC-64 (ECMA-182, as in xz) of several texts. Also covers their lengths, so that "a", "bc" and "ab", "c"
/// differ.
template <typename... Texts>
std::int64_t checksum_of(const Texts&... texts) {
    boost::crc_optimal<64, 0x42F0E1EBA9EA3693, 0xFFFFFFFFFFFFFFFF, 0xFFFFFFFFFFFFFFFF, true, true> crc;
    auto add = [&](std::string_view text) {
        std::uint64_t size = text.size();
        crc.process_bytes(&size, sizeof size);
        crc.process_bytes(text.data(), text.size());
    };
    (add(texts), ...);
    return static_cast<std::int64_t>(crc.checksum());
}

} // namespace placedpar
