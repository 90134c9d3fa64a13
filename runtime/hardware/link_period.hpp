#pragma once

#include "runtime/hardware/link_packets.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace placedpar::hardware {

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
