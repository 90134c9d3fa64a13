#pragma once

#include "runtime/hardware/link_packets.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace placedpar::hardware {

/// How far packets may run by themselves. The acknowledge of the last byte of a part always stops them.
struct LinkLimit {
    Time before = never;          ///< packets that begin at this time or later stay
    bool last_bytes_stop = false; ///< the last byte of a part stays, too
};

/// After a few bytes the two directions of a link repeat themselves: each packet of one begins at the same distance
/// from the packets of the other. From there on whole periods are passed at once, so that a long message costs what a
/// short one does.
///
/// The first members share a line of the cache, since they are read most.
struct alignas(64) LinkPeriod {
    Time since = never; ///< start of the first period; never: no period is known
    Time until{};       ///< bytes_left() holds until then: the last byte of a part, or the end of what was run ahead
    Time length{};      ///< of one period
    /// One direction at the time `since`. Its times count from `since`, in picoseconds.
    struct Pace {
        std::uint32_t bytes_left = 0, bytes_a_period = 0;
        std::int32_t last_start = 0, start_before = 0;
    };
    std::array<Pace, 2> paces;
    std::array<std::uint32_t, 2> part_bytes{}; ///< lengths of the parts under way: a copy, for bytes_begun_before()
    LinkPackets first;                         ///< the packets at the time `since`

    /// Lets all packets within the limit begin, up to the last byte of a part, and notes the period in which they
    /// repeat. Returns whether any packet has begun.
    bool find(LinkPackets&, const PacketTimes&, const LinkLimit&);
    void forget() { since = never; }

    /// Lets packets begin once more that find() ran before, up to a limit that is not beyond that of find().
    void replay(LinkPackets&, const PacketTimes&, const LinkLimit&) const;
    /// Passes as many whole periods as end before that time and before the last byte of a part. REQUIRES: packets.now
    /// is within the period that is known.
    void pass_periods(LinkPackets&, Time before) const;
    /// Whether bytes_left() may be asked for this time and for the picosecond before.
    bool is_simple_around(Time moment) const { return since < moment && moment < until; }
    /// Returns how many bytes a direction has not begun at that time. It has no branch, since the host processor cannot
    /// predict the outcome. REQUIRES: since <= moment < until.
    std::uint32_t bytes_left(std::size_t direction, Time moment) const {
        const Pace& pace = paces[direction];
        std::int64_t periods = (moment - since - Time{pace.last_start}) / length;
        bool one_more = since + Time{pace.start_before} + (periods + 1) * length <= moment;
        return pace.bytes_left - static_cast<std::uint32_t>(periods) * pace.bytes_a_period -
               (std::uint32_t{one_more} & (pace.bytes_a_period >> 1)); // of two
    }

private:
    /// The longest period whose times fit into a Pace.
    static constexpr Time longest_simple{std::numeric_limits<std::int32_t>::max()};

    bool needs_no_passing() const {
        return length <= longest_simple && std::max(paces[0].bytes_a_period, paces[1].bytes_a_period) <= 2;
    }
    void begin(const LinkPackets& then, const LinkPackets& now);
};

} // namespace placedpar::hardware
