#pragma once

#include "runtime/hardware/link_timing.hpp"
#include "runtime/time.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace placedpar::hardware {

/// Stands for a time that never comes.
inline constexpr Time never = Time::max();

/// The packets of a link's two directions, and their times. In each direction bytes and their acknowledges take turns.
/// A packet is asked for at the time `due` and begins when its wire is free. LinkState says what follows from that.
struct LinkPackets {
    /// One direction at the time `now`: the part of a message that is under way, and the next packet.
    struct Stream {
        std::uint32_t bytes_left = 0; ///< bytes of the part that have not begun
        bool acknowledge = false;     ///< the next packet is the acknowledge of the last byte begun; else the next byte
        Time last_start{};            ///< when the last byte began
        Time due = never;             ///< when the next packet is asked for; never: no packet is
        Time start_before{};          ///< when the byte before the last one began
        bool flows() const { return due != never; }
        /// Whether the next packet is the last byte of the part, or the acknowledge of that byte.
        bool ends_part() const { return bytes_left == std::uint32_t{!acknowledge}; }
    };

    Time now{};
    std::array<Stream, 2> streams;
    std::array<Time, 2> free_at{}; ///< wire number i carries the bytes of direction i, and is free from then on

    std::size_t wire_of(std::size_t direction) const { return direction ^ std::size_t{streams[direction].acknowledge}; }
    /// Returns when the direction's next packet begins, if no other packet takes its wire earlier.
    Time begin_of_next(std::size_t direction) const {
        return std::max(streams[direction].due, free_at[wire_of(direction)]);
    }
    /// Begins the direction's next packet now, and times its answer: the acknowledge of a byte, the byte after an
    /// acknowledge. It has no branch, since the host processor cannot predict whether the packet is a byte.
    void begin(const PacketTimes& times, std::size_t direction) {
        Stream& stream = streams[direction];
        const bool acknowledge = stream.acknowledge;
        const PacketTimes::Packet& packet = times.packets[acknowledge];
        const Time last_start = stream.last_start, start_before = stream.start_before;
        free_at[wire_of(direction)] = later(now, packet.carried);
        stream.due = later(now, packet.to_answer);
        stream.bytes_left -= std::uint32_t{!acknowledge};
        stream.last_start = acknowledge ? last_start : now;
        stream.start_before = acknowledge ? start_before : last_start;
        stream.acknowledge = !acknowledge;
    }
};

} // namespace placedpar::hardware
