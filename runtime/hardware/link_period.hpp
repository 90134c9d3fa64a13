#pragma once

#include "runtime/hardware/link_packets.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace placedpar::hardware {

/// A limit for packets (bytes and acknowledges) that are computed together. The acknowledge of a message part's last
/// byte is always beyond the limit.
struct LinkLimit {
    Time before = never;          ///< packets that begin at or after this time are beyond the limit
    bool last_bytes_stop = false; ///< the last byte of a part is beyond the limit, too
};

/// The period of a link's packets. After a few bytes the pattern of bytes and acknowledges on the two wires repeats.
/// From then on the simulation skips whole periods at once, so a long message takes as little host time as a short one.
///
/// The members that are read most often come first, to share a cache line.
struct alignas(64) LinkPeriod {
    Time since = never; ///< start of the first period; never: no period is known
    Time until{};       ///< end of the time for which bytes_left() is valid: the last byte of a part, or the end of the
                        ///< computed packets
    Time length{};      ///< length of one period
    /// One direction at the time `since`. Its times are relative to `since`, in picoseconds.
    struct Pace {
        std::uint32_t bytes_left = 0, bytes_a_period = 0;
        std::int32_t last_start = 0, start_before = 0;
    };
    std::array<Pace, 2> paces;
    std::array<std::uint32_t, 2> part_bytes{}; ///< lengths of the current parts, copied for bytes_begun_before()
    // The packets at the time `since`.
    std::array<LinkPackets::Stream, 2> streams;
    std::array<Time, 2> free_at{};

    /// Begins all packets within the limit, up to the last byte of a part. Stores the period after which their pattern
    /// repeats. Returns whether any packet has begun.
    bool find(LinkPackets&, const PacketTimes&, const LinkLimit&);
    void forget() { since = never; }

    /// Begins the same packets as find() again. REQUIRES: the limit is not beyond the limit of find().
    void replay(LinkPackets&, const PacketTimes&, const LinkLimit&) const;
    /// Skips as many whole periods as end before `before` and before the last byte of a part. REQUIRES: packets.now is
    /// within the known period.
    void pass_periods(LinkPackets&, Time before) const;
    /// Returns whether bytes_left() is valid for this time and for the picosecond before.
    bool is_simple_around(Time moment) const { return since < moment && moment < until; }
    /// Returns how many bytes of the part a direction has not begun at `moment`. The function has no branch, because
    /// the host processor could not predict it. REQUIRES: since <= moment < until.
    std::uint32_t bytes_left(std::size_t direction, Time moment) const {
        const Pace& pace = paces[direction];
        std::int64_t periods = (moment - since - Time{pace.last_start}) / length;
        bool one_more = since + Time{pace.start_before} + (periods + 1) * length <= moment;
        return pace.bytes_left - static_cast<std::uint32_t>(periods) * pace.bytes_a_period -
               (std::uint32_t{one_more} & (pace.bytes_a_period >> 1)); // needed only if a period has two bytes
    }

private:
    /// The longest period whose times fit into a Pace.
    static constexpr Time longest_simple{std::numeric_limits<std::int32_t>::max()};

    bool needs_no_passing() const {
        return length <= longest_simple && std::max(paces[0].bytes_a_period, paces[1].bytes_a_period) <= 2;
    }
    void begin(const LinkPackets& then, const LinkPackets& now, const std::array<Time, 2>& starts_before);
};

} // namespace placedpar::hardware
