#pragma once

#include "runtime/hardware/link_streams.hpp"
#include "runtime/hardware/link_timing.hpp"
#include "runtime/kernel.hpp"
#include "runtime/time.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace placedpar::hardware {

class LinkDirection;

/// The part of a message that is under way in one direction of a link.
struct PartUnderWay {
    std::uint32_t bytes = 0;      ///< 0 between two parts
    std::uint32_t bytes_left = 0; ///< not yet started
    Time last_start{};            ///< of a byte
};

/// The closed form of a link: packets that nobody can see need no events. When one begins, those that follow are
/// computed at once, in both directions (LinkStreams), up to the first that others can see. The directions and the
/// wires then go to that moment, and only the events that follow it are scheduled. If anybody acts on the link before,
/// they come back to the moment at which he does.
///
/// Processors ask for the progress of all their links whenever a computation begins or ends: what that takes stands in
/// two lines of the cache.
class alignas(64) ClosedForm {
public:
    ClosedForm(Kernel&, const PacketTimes&, LinkDirection& a_to_b, LinkDirection& b_to_a);

    /// That of direction 0, from a to b, or 1. While the link is ahead, as it is then.
    PartUnderWay& part(std::size_t direction) { return parts_[direction]; }

    /// REQUIRES: a packet has just begun.
    void look_ahead();
    /// The directions and wires have the state of a moment that is still to come.
    bool is_ahead() const { return kernel_.now() < ahead_until_; }
    /// They have that of now.
    void leave() {
        if (is_ahead())
            come_back();
    }
    /// What a direction has done by now, of the part under way.
    LinkStreams::Progress progress(std::size_t direction) {
        if (!is_ahead())
            return {parts_[direction].bytes_left, parts_[direction].last_start};
        bool repeats = repetition_.since <= kernel_.now() && repetition_.is_simple(direction);
        return repeats ? repetition_.progress(direction, kernel_.now()) : passed_until_now(direction);
    }
    /// One that begins now is not counted: whether it has begun yet depends on the order of this instant's events.
    std::uint32_t bytes_begun_before_now(std::size_t direction) {
        auto [bytes_left, last_start] = progress(direction);
        std::uint32_t bytes = parts_[direction].bytes - bytes_left;
        return bytes > 0 && last_start >= kernel_.now() ? bytes - 1 : bytes;
    }

private:
    Time end_of_what_is_certain() const;
    void follow(Time before);
    void come_back();
    LinkStreams::Progress passed_until_now(std::size_t direction);
    void go_to(const LinkStreams&, Time);

    Kernel& kernel_;
    Time ahead_until_{};
    std::array<PartUnderWay, 2> parts_;
    LinkDirection &a_to_b_, &b_to_a_;
    Repetition repetition_; ///< between the moment of look_ahead() and ahead_until_
    LinkStreams behind_;    ///< at a moment that has been
    const PacketTimes& times_;
};

} // namespace placedpar::hardware
