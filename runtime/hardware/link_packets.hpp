#pragma once

#include "runtime/hardware/link_timing.hpp"
#include "runtime/time.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace placedpar::hardware {

/// A moment that does not come.
inline constexpr Time never = Time::max();

/// The packets of a link's two directions. In each direction bytes and their acknowledges take turns; each is asked for
/// at the moment `due` and begins when its wire is free. This holds how far they are at the moment `now`, and times
/// them; LinkState says what follows from them.
struct LinkPackets {
    /// One direction: the part of a message that is under way, and the packet that comes next.
    struct Stream {
        std::uint32_t bytes_left = 0; ///< not yet begun
        bool acknowledge = false;     ///< the next packet is the acknowledge of the byte begun last, else the next byte
        Time last_start{};            ///< of a byte
        Time due = never;             ///< when the next packet is asked for; never: none is
        Time start_before{};          ///< of the byte before the last one
        bool flows() const { return due != never; }
        /// Its packet is the last byte of the part, or the acknowledge of that.
        bool ends_part() const { return bytes_left == std::uint32_t{!acknowledge}; }
    };

    Time now{};
    std::array<Stream, 2> streams;
    std::array<Time, 2> free_at{}; ///< wire number i carries the bytes of direction i, and is free from then on

    std::size_t wire_of(std::size_t direction) const { return direction ^ std::size_t{streams[direction].acknowledge}; }
    /// When the direction's next packet begins if no other packet takes its wire before.
    Time begin_of_next(std::size_t direction) const {
        return std::max(streams[direction].due, free_at[wire_of(direction)]);
    }
    /// Begins the direction's next packet now, and times its answer: the acknowledge of a byte, the byte after an
    /// acknowledge. No branch stands in it, since the processor cannot foresee whether it is a byte.
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
