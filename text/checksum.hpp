#pragma once

#include <boost/crc.hpp>

#include <cstdint>
#include <string_view>

namespace placedpar {

/// The CRC-64 (ECMA-182, as xz has it) of texts, which are told apart from the same bytes divided otherwise.
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
