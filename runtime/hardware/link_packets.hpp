#pragma once

#include "runtime/hardware/link_timing.hpp"
#include "runtime/time.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

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

/// How far packets may run by themselves.
struct LinkLimit {
    Time before = never;          ///< those that begin earlier
    bool last_bytes_stop = false; ///< and only up to the last byte of a part; its acknowledge always stops them
};

/// After a few bytes the two directions of a link repeat themselves: each packet of one begins at the same distance
/// from the packets of the other. From there on whole periods are passed at once, so that a long message costs what a
/// short one does.
///
/// What is asked for most stands together in one line of the cache.
struct alignas(64) LinkPeriod {
    Time since = never; ///< when it is known
    Time until{};       ///< until then is_simple(): the last byte of a part, or the end of what has been looked at
    Time length{};
    /// A direction at the moment `since`, from which its times count, in picoseconds.
    struct Pace {
        std::uint32_t bytes_left = 0, bytes_a_period = 0;
        std::int32_t last_start = 0, start_before = 0;
    };
    std::array<Pace, 2> paces;
    std::array<std::uint32_t, 2> part_bytes{}; ///< of the parts under way: kept here for who asks how many have begun
    LinkPackets first;                         ///< all that the link does at that moment

    /// Lets all packets within the limit begin, up to the last byte of a part, and notes what they repeat from some
    /// moment on. Returns whether there are any.
    bool find(LinkPackets&, const PacketTimes&, const LinkLimit&);
    void forget() { since = never; }

    /// Does the same once more, of packets that find() has been given or gone through, up to another limit within that
    /// one.
    void run(LinkPackets&, const PacketTimes&, const LinkLimit&) const;
    /// Passes as many whole periods as end before that moment and before the last byte of a part. REQUIRES: the period
    /// is known at the moment of the packets.
    void pass_periods(LinkPackets&, Time before) const;
    /// Whether bytes_left() is known without passing packets, nearly always.
    bool is_simple(Time moment) const { return since <= moment && moment < until; }
    /// The same, and just before that moment.
    bool is_simple_around(Time moment) const { return since < moment && moment < until; }
    /// How many bytes a direction has not begun by that moment, without a branch, since the processor cannot foresee
    /// the outcome. REQUIRES: is_simple(moment).
    std::uint32_t bytes_left(std::size_t direction, Time moment) const {
        const Pace& pace = paces[direction];
        std::int64_t periods = (moment - since - Time{pace.last_start}) / length;
        bool one_more = since + Time{pace.start_before} + (periods + 1) * length <= moment;
        return pace.bytes_left - static_cast<std::uint32_t>(periods) * pace.bytes_a_period -
               (std::uint32_t{one_more} & (pace.bytes_a_period >> 1)); // of two
    }

private:
    /// So that moments of the period before `since` fit a pace.
    static constexpr Time longest_simple{std::numeric_limits<std::int32_t>::max()};

    bool needs_no_passing() const {
        return length <= longest_simple && std::max(paces[0].bytes_a_period, paces[1].bytes_a_period) <= 2;
    }
    void begin(const LinkPackets& then, const LinkPackets& now);
};

} // namespace placedpar::hardware
