#pragma once

#include "runtime/hardware/link_timing.hpp"
#include "runtime/time.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace placedpar::hardware {

/// A time that never comes.
inline constexpr Time never = Time::max();
/// The time of each step that would come after the end of virtual time. If no other event is left, such a step ends the
/// run with an error.
inline constexpr Time too_late = never - Time{1};
/// Returns `t + by`, at most too_late. REQUIRES: 0 <= t <= too_late.
constexpr Time time_of_step(Time t, Time by) { return by > too_late - t ? too_late : t + by; }

/// The packets of a link's two directions, with their times. In each direction bytes and their acknowledges alternate.
/// A packet is requested at the time `due`, and begins when its wire is free. LinkState defines the consequences.
struct LinkPackets {
    /// One direction at the time `now`: the current part of a message, and the next packet.
    struct Stream {
        std::uint32_t bytes_left = 0; ///< bytes of the part that have not begun
        bool acknowledge = false;     ///< true: the next packet is the acknowledge of the last byte that began; false:
                                      ///< the next byte
        Time last_start{};            ///< start of the last byte that began
        Time due = never;             ///< time at which the next packet is requested; never: there is no next packet
        bool flows() const { return due != never; }
        /// Returns whether the next packet is the last byte of the part, or the acknowledge of this byte.
        bool ends_part() const { return bytes_left == std::uint32_t{!acknowledge}; }
    };

    Time now{};
    std::array<Stream, 2> streams;
    std::array<Time, 2> free_at{}; ///< time at which each wire becomes free; wire i carries the bytes of direction i

    std::size_t wire_of(std::size_t direction) const { return direction ^ std::size_t{streams[direction].acknowledge}; }
    /// Returns the start of the direction's next packet, unless another packet takes its wire earlier.
    Time begin_of_next(std::size_t direction) const {
        return std::max(streams[direction].due, free_at[wire_of(direction)]);
    }
    /// Begins the direction's next packet now, and schedules its answer: a byte is answered by its acknowledge, an
    /// acknowledge by the next byte. Has no branch, because the host processor cannot predict whether the packet is a
    /// byte.
    void begin(const PacketTimes& times, std::size_t direction) {
        Stream& stream = streams[direction];
        const bool acknowledge = stream.acknowledge;
        const PacketTimes::Packet& packet = times.packets[acknowledge];
        const Time last_start = stream.last_start;
        free_at[wire_of(direction)] = time_of_step(now, packet.carried);
        stream.due = time_of_step(now, packet.to_answer);
        stream.bytes_left -= std::uint32_t{!acknowledge};
        stream.last_start = acknowledge ? last_start : now;
        stream.acknowledge = !acknowledge;
    }
};

} // namespace placedpar::hardware
