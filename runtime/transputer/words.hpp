#pragma once

#include "runtime/transputer/model.hpp"

#include <bit>
#include <cstdint>
#include <tuple>

/// Functions on words for a transputer's instructions, and the values that its scheduler keeps in memory.
namespace placedpar::transputer {

inline constexpr Word sign_bit = 0x8000'0000;

constexpr std::int32_t signed_of(Word word) { return static_cast<std::int32_t>(word); }

/// Returns the number of the highest bit that is set; 0 for 0.
constexpr Word top_bit(Word word) { return word == 0 ? 0 : static_cast<Word>(31 - std::countl_zero(word)); }

/// Returns the cycles of a shift of two words by this number of places, as in lshl, beyond the first 3 cycles.
constexpr Word cycles_of_long_shift(Word places) {
    if (places < 32)
        return places;
    return places < 64 ? places - 31 : 36 - 3;
}

/// Shifts data through a cyclic redundancy check. Returns A, B and C after crcword (32 bits) or crcbyte (8 bits).
constexpr std::tuple<Word, Word, Word> crc(Word data, Word sum, Word generator, int bits) {
    for (int i = 0; i < bits; ++i) {
        const bool out = sum & sign_bit;
        sum = sum << 1 | data >> 31;
        data <<= 1;
        if (out)
            sum ^= generator;
    }
    return {sum, generator, sum};
}

/// Returns the bits of a word in the opposite order.
constexpr Word reversed(Word word) {
    Word result = 0;
    for (int i = 0; i < 32; ++i, word >>= 1)
        result = result << 1 | (word & 1);
    return result;
}

/// The number of channels of links, including the event channel.
inline constexpr Word hard_channels = 9;

/// Returns the number of a link's channel: 0 to 3 for outputs, 4 to 7 for inputs, 8 for the event channel. Returns -1
/// for any other address.
constexpr int hard_channel(Word address) {
    const Word offset = address - most_negative;
    return offset < 4 * hard_channels ? static_cast<int>(offset / 4) : -1;
}

/// The words below a workspace while its process waits, as offsets in bytes.
namespace below {
inline constexpr Word instruction = 4, link = 8, state = 12, pointer = 12, timer_link = 16, time = 20;
} // namespace below

/// Values that the instructions of an ALT store in the words of its process.
namespace alternative {
inline constexpr Word enabling = most_negative + 1, waiting = most_negative + 2, ready = most_negative + 3;
inline constexpr Word time_set = most_negative + 1, time_not_set = most_negative + 2;
inline constexpr Word none_selected = ~Word{0};
} // namespace alternative

/// Addresses below MemStart, which the processor uses itself.
namespace reserved {
inline constexpr Word outputs = most_negative, inputs = most_negative + 0x10, event = most_negative + 0x20;
inline constexpr Word timer_heads = most_negative + 0x24; ///< the head for high priority, then the head for low
                                                          ///< priority
inline constexpr Word saved = most_negative + 0x2C; ///< Wdesc, Iptr, A, B, C, Status, E of the interrupted process
} // namespace reserved

} // namespace placedpar::transputer
