#pragma once

#include "runtime/hardware/link_timing.hpp"
#include "runtime/time.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace placedpar::hardware {

/// The bytes that go over a link in both directions, and their acknowledges, without events: while nobody looks, a loop
/// over integers. By the rules of Wire, to the picosecond.
///
/// After a few bytes the two directions repeat themselves: each packet of one begins at the same distance from the
/// packets of the other. From there on whole periods are passed at once, so that a long message costs what a short one
/// does.
class LinkStreams {
public:
    /// How far the part of a message is that is under way in one direction.
    struct Progress {
        std::uint32_t bytes_left = 0; ///< not yet begun
        Time last_start{};            ///< of a byte
    };
    /// And its next packet.
    struct Stream : Progress {
        bool flows = false;       ///< a packet of it is to come
        bool acknowledge = false; ///< which is the acknowledge of the byte begun last, else the next byte
        Time due{};               ///< when it is asked for
    };
    /// Of a packet that is asked for already, and waits for the wire.
    static constexpr Time past{-1};

    LinkStreams() = default;
    /// At that moment. Wire number i carries the bytes of direction i, and is free from free_at[i] on.
    LinkStreams(Time now, const std::array<Stream, 2>& streams, const std::array<Time, 2>& free_at)
        : now_(now), streams_(streams), free_at_(free_at) {}

    /// Lets all packets begin that do so before that moment, up to the first of those that others can see: the last
    /// byte of a part, or its acknowledge.
    void advance(const PacketTimes&, Time before);

    /// When the last packet began.
    Time now() const { return now_; }
    const Stream& stream(std::size_t direction) const { return streams_[direction]; }
    Time free_at(std::size_t wire) const { return free_at_[wire]; }

private:
    /// Where the other direction is when a direction begins a byte. If it is there again, everything repeats itself.
    struct Phase {
        bool acknowledge = false;
        Time due{}, free_at{}; ///< from now on
        bool operator==(const Phase&) const = default;
    };

    std::size_t wire_of(std::size_t direction) const {
        return direction ^ std::size_t{streams_[direction].acknowledge};
    }
    Time begin_of_next(std::size_t direction) const;
    std::size_t next_direction() const;
    bool is_seen(const Stream&) const;
    void begin_packet(const PacketTimes&, std::size_t direction);
    Phase phase_of(std::size_t other) const;
    void watch_for_period(std::size_t other, Time before);
    void pass_periods(Time before);

    Time now_{};
    std::array<Stream, 2> streams_;
    std::array<Time, 2> free_at_{};

    // The moment that the present is compared with: a later one each time that twice as many bytes have begun.
    Phase noted_;
    Time noted_at_{};
    std::array<std::uint32_t, 2> bytes_left_then_{};
    std::uint32_t bytes_until_note_ = 1, bytes_between_notes_ = 1;
};

} // namespace placedpar::hardware
