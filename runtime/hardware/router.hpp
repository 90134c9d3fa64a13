#pragma once

#include "runtime/carrier.hpp"
#include "runtime/channel.hpp"
#include "runtime/hardware/link.hpp"
#include "runtime/process.hpp"
#include "runtime/source_location.hpp"

#include <algorithm>
#include <cstdint>
#include <deque>
#include <list>
#include <string>
#include <vector>

namespace placedpar {
class Executive;
class Kernel;
} // namespace placedpar

namespace placedpar::hardware {

class Route;

/// What routers send each other: a part of a message on its way, or the acknowledge of one on its way back.
struct RouterPacket {
    static constexpr std::uint32_t header_bytes = 4; ///< ours: one word names the channel and the kind of packet
    static constexpr std::int64_t most_bytes = 256;  ///< ours: bytes of a message in one packet

    Route* route;
    bool acknowledge;
    bool last;       ///< the packet is the last of its message
    std::size_t hop; ///< index in the route of the link that the packet goes over, or has come by
    std::int64_t bytes;

    WireForm wire_form() const { return WireForm(header_bytes + bytes); }
};

/// What a router asks of the processor that it is at.
struct RouterCosts {
    /// The priority of the two processes at each link. At high priority they pre-empt a computing process of low
    /// priority. At low priority they wait behind it, up to two timeslice periods for each packet that they send or
    /// receive.
    Priority priority = Priority::high;
    /// A packet sent, or received, besides the instructions. Ours: queueing, looking up the route, rescheduling.
    Cycles handling{200};
};

/// Passes on packets at one processor: several channels share a link, and channels lead over processors between. At
/// each link that it uses two processes send and receive packets. What has come is for a process here, or goes on over
/// another link. Channels whose packets wait for a link take turns, one packet each, so that a long message does not
/// block a short one.
///
/// This costs the links a header on each packet, and the processors RouterCosts::handling for each packet sent and
/// received besides the instructions: a packet that is passed on is both.
///
/// No deadlock can come of it, however the routes lead. A receiver never waits for anything but its link: it takes
/// every packet that comes, since there is room for it. There is, since no more than Route::most_under_way packets of a
/// channel and acknowledges of them exist at a time, and each router on its route keeps room for so many. So a packet
/// that has a link's turn gets over it, turns come round, and every packet arrives, whatever processes do; a channel
/// waits for its processes only.
///
/// Where a link loses something of a packet (link_faults.hpp), or a processor has halted, packets stand still from then
/// on: routers do not repeat them. The channels of those that are there wait for ever; others go on.
class Router {
public:
    /// At the processor that `executive` is; null is infinitely fast. Throws std::logic_error if the handling is
    /// negative.
    explicit Router(Kernel&, Executive* executive, const RouterCosts& = {});
    Router(const Router&) = delete;
    Router& operator=(const Router&) = delete;

    /// Packets that came from one link and went on over another, and what they cost the processor, instructions
    /// included; not what it took to interrupt others, at most once when one comes and once when it has gone.
    std::uint64_t packets_passed_on() const { return packets_passed_on_; }
    Cycles cycles_of_passing_on() const;

private:
    friend class RouterLink;
    friend class Route;

    /// The two processes at one link, and the packets that wait to be sent.
    class Port {
    public:
        /// The packets of the other end come by `in`.
        Port(Router&, const std::string& to, const std::string& from, Channel<RouterPacket>& out,
             Channel<RouterPacket>& in);
        void post(const RouterPacket&);
        void is_opposite(const Port& other) { opposite_ = &other; }

        bool is_on(const Executive& executive) const { return router_.executive_ == &executive; }
        bool halted() const;
        /// Returns whether no packet that waits here will ever get over the link.
        bool stands_still() const;
        bool holds_packet_of(const Route&) const;

    private:
        void send_packets();
        void receive_packets();
        RouterPacket take_turn();

        Router& router_;
        Channel<RouterPacket>& out_;
        Channel<RouterPacket>& in_;
        const Port* opposite_ = nullptr;    ///< at the other end of the link
        const Route* being_sent_ = nullptr; ///< route of the packet that the sender has
        bool on_link_ = false;              ///< the sender is outputting that packet
        std::deque<std::deque<RouterPacket>>
            turns_;                ///< the packets of each channel that has any, the next to send first
        bool sender_idle_ = false; ///< it waits for a packet to send
        Process sender_, receiver_;
    };

    Kernel& kernel_;
    Executive* executive_;
    RouterCosts costs_;
    std::list<Port> ports_;
    std::uint64_t packets_passed_on_ = 0;
};

/// One direction of what routers send their packets over: of a link, or of a way over a bus.
struct RouterLane {
    Carrier& carrier;
    std::string name;
};

/// A link, or a way over a bus, whose channels travel in packets, between two routers. REQUIRES: nothing else uses it.
class RouterLink {
public:
    RouterLink(Kernel&, Link&, Router& a, Router& b);
    RouterLink(Kernel&, const RouterLane& a_to_b, const RouterLane& b_to_a, Router& a, Router& b);

private:
    friend class Route;

    Channel<RouterPacket> a_to_b_, b_to_a_;
    Router::Port &a_, &b_;
};

/// One step of a route: over a link, to the router at its other end.
struct Hop {
    RouterLink& link;
    bool from_a_to_b;
};

/// A channel that travels in packets, over one link or several. It is a rendezvous as any other: the outputting process
/// goes on when the last packet's acknowledge has come back. A packet is acknowledged when the inputting process takes
/// it; till then it waits at the receiving end, and a channel whose receiver is late stops no other.
class Route final : public Carrier {
public:
    static constexpr std::size_t most_under_way = 4; ///< ours: packets that the sender is ahead of acknowledges
    /// Bytes of memory that each processor on the route, both ends included, reserves for the channel.
    static constexpr std::int64_t room = most_under_way * (RouterPacket::header_bytes + RouterPacket::most_bytes);

    /// REQUIRES: at least one hop; each begins at the router where the one before ends, and none is passed twice.
    Route(Kernel&, const std::vector<Hop>&);

    void output(AnyChannel&, const WireForm&, const SourceLocation&) override;
    void input(AnyChannel&, const SourceLocation&) override;
    bool message_waits(const AnyChannel&) const override { return !here_.empty(); }
    std::string why_not_given_up() const override { return "travels in packets, which routers carry to their end"; }
    /// Returns whether a packet of the current message, or the acknowledge of a packet, stands still.
    bool output_is_lost(const AnyChannel&) const override { return is_stopped(); }
    bool input_is_lost(const AnyChannel&) const override { return inputter_ && is_stopped(); }
    /// It does at this link; it does since this processor, which it leads from, to or over, has halted.
    bool is_stopped_at(const RouterLink&) const;
    bool is_stopped_by(const Executive&) const;

private:
    friend class Router;

    bool is_stopped() const;
    template <class Has>
    bool any_port(Has has) const {
        return std::ranges::any_of(forth_, has) || std::ranges::any_of(back_, has);
    }

    /// Advances the packet, which has come over a link; returns the port by which it is sent on, or null if it has
    /// arrived.
    Router::Port* onward(RouterPacket&) const;
    void arrived(const RouterPacket&);
    void send_packet();
    void take(const RouterPacket&);

    std::vector<Router::Port*> forth_, back_; ///< that packets and acknowledges leave by, hop by hop
    AnyChannel* channel_ = nullptr;

    // The message under way:
    Process* outputter_ = nullptr;
    std::int64_t bytes_left_ = 0; ///< not yet sent
    bool all_sent_ = false;
    std::size_t under_way_ = 0; ///< number of packets sent and not yet acknowledged

    Process* inputter_ = nullptr;   ///< from when it asks for a message until it has it
    std::deque<RouterPacket> here_; ///< arrived, and no process has taken them
};

} // namespace placedpar::hardware
