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

/// A packet that routers send over a link: a part of a message, or an acknowledge that returns to the sender.
struct RouterPacket {
    static constexpr std::uint32_t header_bytes = 4; ///< our choice: one word for the channel and the kind of packet
    static constexpr std::int64_t most_bytes = 256;  ///< our choice: the most bytes of a message in one packet

    Route* route;
    bool acknowledge;
    bool last;       ///< the packet is the last of its message
    std::size_t hop; ///< index in the route of the link that the packet will use next, or has just used
    std::int64_t bytes;

    WireForm wire_form() const { return WireForm(header_bytes + bytes); }
};

/// What a router costs its processor.
struct RouterCosts {
    /// The priority of the two processes at each link. At high priority they pre-empt a process of low priority that
    /// computes. At low priority they wait for it, up to two timeslice periods for each packet that they send or
    /// receive.
    Priority priority = Priority::high;
    /// Cost of sending or receiving a packet, beyond the instructions `out` and `in`: queueing the packet, looking up
    /// its route, and rescheduling. The figure is our choice.
    Cycles handling{200};
};

/// Sends and passes on packets at one processor. With routers, several channels can share a link, and a channel can
/// lead over other processors. At each link of the router, one process sends packets and one receives them. A packet
/// that arrives is for a process of this processor, or continues over another link. Channels whose packets wait for a
/// link take turns, with one packet in each turn, so that a long message does not block a short one.
///
/// Each packet has a header of 4 bytes. A processor spends RouterCosts::handling and the instructions when it sends a
/// packet and when it receives one. A processor that passes on a packet does both.
///
/// Routing cannot cause a deadlock, whatever the routes are. Each router on a channel's route reserves room for
/// Route::most_under_way packets and their acknowledges, and the channel never has more packets under way. So a router
/// always has room for a packet that arrives, and every packet gets its turn and arrives. A channel waits only for its
/// own processes.
///
/// Routers do not repeat packets. If a link loses a part of a packet (link_faults.hpp) or a processor halts, the
/// channels with packets there wait for ever; other channels continue.
class Router {
public:
    /// Makes a router on the processor `executive`; null means an infinitely fast processor. Throws std::logic_error if
    /// the handling is negative.
    explicit Router(Kernel&, Executive* executive, const RouterCosts& = {});
    Router(const Router&) = delete;
    Router& operator=(const Router&) = delete;

    /// Return the number of packets that were passed on from one link to another, and the cycles that they cost the
    /// processor, including instructions. The cycles of interrupting another process, at most twice for each packet,
    /// are not included.
    std::uint64_t packets_passed_on() const { return packets_passed_on_; }
    Cycles cycles_of_passing_on() const;

private:
    friend class RouterLink;
    friend class Route;

    /// The two processes at one link, with the packets that wait to be sent.
    class Port {
    public:
        /// `in`: the channel on which packets from the other end arrive.
        Port(Router&, const std::string& to, const std::string& from, Channel<RouterPacket>& out,
             Channel<RouterPacket>& in);
        void post(const RouterPacket&);
        void is_opposite(const Port& other) { opposite_ = &other; }

        bool is_on(const Executive& executive) const { return router_.executive_ == &executive; }
        bool halted() const;
        /// Returns whether the packets that wait here will never cross the link.
        bool stands_still() const;
        bool holds_packet_of(const Route&) const;

    private:
        void send_packets();
        void receive_packets();
        RouterPacket take_turn();

        Router& router_;
        Channel<RouterPacket>& out_;
        Channel<RouterPacket>& in_;
        const Port* opposite_ = nullptr;    ///< the port at the other end of the link
        const Route* being_sent_ = nullptr; ///< route of the packet that the sender is sending
        bool on_link_ = false;              ///< the sender is outputting this packet
        std::deque<std::deque<RouterPacket>>
            turns_;                ///< packets that wait, grouped by channel; a packet of the first group is sent next
        bool sender_idle_ = false; ///< the sender waits for a packet to send
        Process sender_, receiver_;
    };

    Kernel& kernel_;
    Executive* executive_;
    RouterCosts costs_;
    std::list<Port> ports_;
    std::uint64_t packets_passed_on_ = 0;
};

/// One direction of a link or of a path over a bus, over which routers send packets.
struct RouterLane {
    Carrier& carrier;
    std::string name;
};

/// A link, or a path over a bus, between two routers. It carries the packets of any number of channels. REQUIRES:
/// nothing else uses the link.
class RouterLink {
public:
    RouterLink(Kernel&, Link&, Router& a, Router& b);
    RouterLink(Kernel&, const RouterLane& a_to_b, const RouterLane& b_to_a, Router& a, Router& b);

private:
    friend class Route;

    Channel<RouterPacket> a_to_b_, b_to_a_;
    Router::Port &a_, &b_;
};

/// One step of a route: over a link to the router at its other end.
struct Hop {
    RouterLink& link;
    bool from_a_to_b;
};

/// Carries the messages of one channel in packets over one or more links. The inputting process's end acknowledges a
/// packet when the process takes it. The outputting process continues when the acknowledge of its last packet has
/// returned. Until a packet is taken, it waits at the receiving end, so a channel with a late receiver does not block
/// other channels.
class Route final : public Carrier {
public:
    static constexpr std::size_t most_under_way = 4; ///< our choice: the most packets that are sent and not yet
                                                     ///< acknowledged
    /// The memory that each processor on the route, including both ends, reserves for the channel, in bytes.
    static constexpr std::int64_t room = most_under_way * (RouterPacket::header_bytes + RouterPacket::most_bytes);

    /// REQUIRES: there is at least one hop, each hop begins at the router where the previous hop ends, and no hop
    /// occurs twice.
    Route(Kernel&, const std::vector<Hop>&);

    void output(AnyChannel&, const WireForm&, const SourceLocation&) override;
    void input(AnyChannel&, const SourceLocation&) override;
    bool message_waits(const AnyChannel&) const override { return !here_.empty(); }
    std::string why_not_given_up() const override { return "travels in packets, which routers carry to their end"; }
    /// Returns whether a packet of the current message, or its acknowledge, will never arrive.
    bool output_is_lost(const AnyChannel&) const override { return is_stopped(); }
    bool input_is_lost(const AnyChannel&) const override { return inputter_ && is_stopped(); }
    /// Return whether a packet is stopped at this link, or by this halted processor on the route.
    bool is_stopped_at(const RouterLink&) const;
    bool is_stopped_by(const Executive&) const;

private:
    friend class Router;

    bool is_stopped() const;
    template <class Has>
    bool any_port(Has has) const {
        return std::ranges::any_of(forth_, has) || std::ranges::any_of(back_, has);
    }

    /// Notes that the packet has arrived over a link. Returns the port that sends it on, or null if its route ends
    /// here.
    Router::Port* onward(RouterPacket&) const;
    void arrived(const RouterPacket&);
    void send_packet();
    void take(const RouterPacket&);

    std::vector<Router::Port*> forth_, back_; ///< ports by which packets and acknowledges leave, in the order of the
                                              ///< hops
    AnyChannel* channel_ = nullptr;

    // The current message:
    Process* outputter_ = nullptr;
    std::int64_t bytes_left_ = 0; ///< bytes not yet sent
    bool all_sent_ = false;
    std::size_t under_way_ = 0; ///< number of packets sent and not yet acknowledged

    Process* inputter_ = nullptr;   ///< set while a process waits for a message
    std::deque<RouterPacket> here_; ///< packets that have arrived and not been taken
};

} // namespace placedpar::hardware
