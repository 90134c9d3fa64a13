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
/// The time of any step beyond the end of virtual time. If only such steps are left, the run ends with an error.
inline constexpr Time too_late = never - Time{1};
/// Returns `t + by`, at most too_late. REQUIRES: 0 <= t <= too_late.
constexpr Time time_of_step(Time t, Time by) { return by > too_late - t ? too_late : t + by; }

/// The times of the packets of a link's two directions. A packet is a byte or an acknowledge. In each direction bytes
/// and their acknowledges alternate; an acknowledge travels on the wire of the opposite direction. A packet is
/// requested at the time `due`, and begins when its wire is free. LinkState defines what follows from a packet.
struct LinkPackets {
    /// One direction at the time `now`. A part is a piece of a message that the sender sends by one instruction.
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
    /// Returns when the direction's next packet begins if no other packet takes its wire before.
    Time begin_of_next(std::size_t direction) const {
        return std::max(streams[direction].due, free_at[wire_of(direction)]);
    }
    /// Begins the direction's next packet now. Schedules the answer: the acknowledge after a byte, the next byte after
    /// an acknowledge. The function has no branch, because the host processor could not predict it.
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
