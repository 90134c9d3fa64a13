#pragma once

#include "runtime/hardware/link_timing.hpp"
#include "runtime/time.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

namespace placedpar::hardware {

/// The bytes that go over a link in both directions, and their acknowledges, without events: while nobody looks, a loop
/// over integers. By the rules of Wire, to the picosecond. This is where they are at a moment.
struct LinkStreams {
    /// How far the part of a message is that is under way in one direction.
    struct Progress {
        std::uint32_t bytes_left = 0; ///< not yet begun
        Time last_start{};            ///< of a byte
    };
    /// And its next packet.
    struct Stream {
        std::uint32_t bytes_left = 0;
        bool acknowledge = false; ///< it is the acknowledge of the byte begun last, else the next byte
        Time last_start{};
        Time due = Time::max(); ///< when the packet is asked for; none is to come: never
        Time start_before{};    ///< of the byte before the last, if it began here
        bool flows() const { return due != Time::max(); }
    };
    static constexpr Time past{-1};

    Time now{}; ///< when the last packet began
    std::array<Stream, 2> streams;
    std::array<Time, 2> free_at{};    ///< wire number i carries the bytes of direction i, and is free from then on
    bool last_bytes_are_seen = false; ///< of parts; their acknowledges always are

    /// Whether begin_next does something.
    bool may_advance(Time before) const { return next(before).has_value(); }
    /// Lets the next packet begin, if it does so before that moment, and others cannot see it. Returns its direction.
    std::optional<std::size_t> begin_next(const PacketTimes&, Time before);
    /// All of these.
    void advance(const PacketTimes& times, Time before) {
        while (begin_next(times, before)) {
        }
    }
    /// When the first of the last bytes of parts began, of those that have; else the end of time.
    Time end_of_a_part() const;
    /// Whether everything will come again as it came then, seen from each moment. REQUIRES: the direction that is not
    /// `other` began a byte at both.
    bool is_in_phase_with(const LinkStreams& then, std::size_t other) const;

private:
    struct Next {
        std::size_t direction;
        Time begins;
    };
    std::optional<Next> next(Time before) const;
    std::size_t wire_of(std::size_t direction) const { return direction ^ std::size_t{streams[direction].acknowledge}; }
    Time begin_of_next(std::size_t direction) const;
    void begin_packet(const PacketTimes&, std::size_t direction);
};

/// After a few bytes the two directions of a link repeat themselves: each packet of one begins at the same distance
/// from the packets of the other. From there on whole periods are passed at once, so that a long message costs what a
/// short one does.
///
/// What is asked for most stands together in one line of the cache.
struct alignas(64) Repetition {
    Time since = Time::max(); ///< when it is known
    Time until{}; ///< until then is_simple(): the last byte of a part, or the end of what has been looked at
    Time period{};
    /// Of a direction at the moment `since`, from which its times count, in picoseconds.
    struct Flow {
        std::uint32_t bytes_left = 0, bytes_a_period = 0;
        std::int32_t last_start = 0, start_before = 0;
    };
    std::array<Flow, 2> flows;
    std::array<std::uint32_t, 2> part_bytes{}; ///< of the parts under way: kept here for who asks how many have begun
    LinkStreams first;                         ///< all that the link does at that moment

    /// Lets all packets begin as LinkStreams::advance does, and notes what the streams repeat from some moment on.
    void find(LinkStreams&, const PacketTimes&, Time before);
    void forget() { since = Time::max(); }

    /// Passes as many whole periods as end before that moment and before the last byte of a part. REQUIRES: it is known
    /// at the moment of the streams.
    void pass_periods(LinkStreams&, Time before) const;
    /// Whether progress() is known without passing packets: nearly always.
    bool is_simple(Time moment) const { return since <= moment && moment < until; }
    /// The same, and just before that moment.
    bool is_simple_around(Time moment) const { return since < moment && moment < until; }
    /// How far a direction is at that moment. REQUIRES: is_simple(moment).
    LinkStreams::Progress progress(std::size_t direction, Time moment) const {
        const Flow& flow = flows[direction];
        Time last_start = since + Time{flow.last_start};
        if (flow.bytes_a_period == 0)
            return {flow.bytes_left, last_start};
        std::int64_t periods = (moment - last_start) / period;
        Time start = last_start + periods * period, next = since + Time{flow.start_before} + (periods + 1) * period;
        return {bytes_left(direction, moment), flow.bytes_a_period == 2 && next <= moment ? next : start};
    }
    /// The same, only the bytes: without a branch, since the processor cannot foresee the outcome.
    std::uint32_t bytes_left(std::size_t direction, Time moment) const {
        const Flow& flow = flows[direction];
        std::int64_t periods = (moment - since - Time{flow.last_start}) / period;
        bool one_more = since + Time{flow.start_before} + (periods + 1) * period <= moment;
        return flow.bytes_left - static_cast<std::uint32_t>(periods) * flow.bytes_a_period -
               (std::uint32_t{one_more} & (flow.bytes_a_period >> 1)); // of two
    }

private:
    /// So that moments of the period before `since` fit a flow.
    static constexpr Time longest_simple{std::numeric_limits<std::int32_t>::max()};

    bool needs_no_passing() const {
        return period <= longest_simple && std::max(flows[0].bytes_a_period, flows[1].bytes_a_period) <= 2;
    }
    void begin(const LinkStreams& then, const LinkStreams& now);
};

} // namespace placedpar::hardware
