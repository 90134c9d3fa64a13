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
        Time start_before{};      ///< of the byte before the last, if it began here
    };
    /// When a packet is due that has been asked for already and waits for its wire.
    static constexpr Time past{-1};

    LinkStreams() = default;
    /// At that moment. Wire number i carries the bytes of direction i, and is free from free_at[i] on.
    LinkStreams(Time now, const std::array<Stream, 2>& streams, const std::array<Time, 2>& free_at)
        : at_{now, streams, free_at} {}

    /// Lets all packets begin that do so before that moment, up to the first of those that others can see: the last
    /// byte of a part, or its acknowledge.
    void advance(const PacketTimes&, Time before);
    /// How far a direction is at that moment. REQUIRES: it is not before now(), and nothing has been seen by then.
    Progress progress(const PacketTimes&, std::size_t direction, Time moment);

    /// From when on it is known that everything repeats itself: Time::max() while it is not.
    Time repeats_since() const { return period_ > Time{0} ? noted_.now : Time::max(); }
    /// Goes back to that moment. REQUIRES: it is known.
    void go_back_to_repetition() { at_ = noted_; }

    /// When the last packet began.
    Time now() const { return at_.now; }
    const Stream& stream(std::size_t direction) const { return at_.streams[direction]; }
    Time free_at(std::size_t wire) const { return at_.free_at[wire]; }

private:
    struct State {
        Time now{};
        std::array<Stream, 2> streams;
        std::array<Time, 2> free_at{};

        std::size_t wire_of(std::size_t direction) const {
            return direction ^ std::size_t{streams[direction].acknowledge};
        }
        Time begin_of_next(std::size_t direction) const;
        void begin_packet(const PacketTimes&, std::size_t direction);
        bool is_in_phase_with(const State&, std::size_t other) const;
    };
    bool watch_for_repetition(std::size_t other);
    void pass_periods(Time before);

    State at_;
    State noted_; ///< a moment that the present is compared with: a later one each time that twice as many bytes began
    std::uint32_t bytes_until_note_ = 1, bytes_between_notes_ = 1;
    Time period_{};                                 ///< 0 until it is known
    std::array<std::uint32_t, 2> bytes_a_period_{}; ///< of each direction
};

} // namespace placedpar::hardware
