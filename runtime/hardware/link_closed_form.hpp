#pragma once

#include "runtime/hardware/link_streams.hpp"
#include "runtime/time.hpp"

namespace placedpar {
class Kernel;
} // namespace placedpar

namespace placedpar::hardware {

class LinkDirection;

/// The closed form of a link: packets that nobody can see need no events. When one begins, those that follow are
/// computed at once, in both directions (LinkStreams), up to the first that others can see. The directions and the
/// wires then go to that moment, and only the events that follow it are scheduled. If anybody acts on the link before,
/// they come back to the moment at which he does.
class ClosedForm {
public:
    ClosedForm(Kernel&, const PacketTimes&, LinkDirection& a_to_b, LinkDirection& b_to_a);

    /// REQUIRES: a packet has just begun.
    void look_ahead();
    /// The directions and wires have the state of a moment that is still to come.
    bool is_ahead() const;
    /// They have that of now.
    void leave() {
        if (is_ahead())
            come_back();
    }
    /// What the direction has done by now. REQUIRES: is_ahead().
    LinkStreams::Progress now(const LinkDirection&);

private:
    Time end_of_what_is_certain() const;
    void follow();
    void come_back();
    void go_to(const LinkStreams&, Time);

    Kernel& kernel_;
    const PacketTimes& times_;
    LinkDirection &a_to_b_, &b_to_a_;
    LinkStreams behind_; ///< at a moment that has been
    LinkStreams ahead_;  ///< where the directions and wires are
    Time ahead_until_{};
};

} // namespace placedpar::hardware
