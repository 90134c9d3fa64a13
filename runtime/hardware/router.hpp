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

/// A packet between routers: a part of a message, or an acknowledge that returns.
struct RouterPacket {
    static constexpr std::uint32_t header_bytes = 4; ///< ours: one word for the channel and the kind of packet
    static constexpr std::int64_t most_bytes = 256;  ///< ours: largest number of a message's bytes in one packet

    Route* route;
    bool acknowledge;
    bool last;       ///< the packet is the last of its message
    std::size_t hop; ///< index in the route of the link that the packet will use next, or has just used
    std::int64_t bytes;

    WireForm wire_form() const { return WireForm(header_bytes + bytes); }
};

/// The costs of a router for its processor.
struct RouterCosts {
    /// The priority of the two processes at each link. At high priority they pre-empt a computing process of low
    /// priority. At low priority they wait for such a process, up to two timeslice periods for each packet that they
    /// send or receive.
    Priority priority = Priority::high;
    /// Cost of sending or receiving a packet, in addition to the instructions. Ours: queueing, looking up the route,
    /// rescheduling.
    Cycles handling{200};
};

/// Passes on packets at one processor. So several channels can share a link, and a channel can lead over other
/// processors. At each link of the router, two processes send and receive packets. A packet that arrives is for a
/// process here, or continues over another link. Channels whose packets wait for a link take turns, with one packet in
/// each turn, so that a long message does not block a short one.
///
/// Each packet costs the links a header. It costs a processor RouterCosts::handling, in addition to the instructions,
/// when it is sent and when it is received. A packet that is passed on is both received and sent.
///
/// Routing cannot cause a deadlock, whatever the routes are. A receiver waits only for its link, because there is
/// always room for a packet. A channel has at most Route::most_under_way packets and their acknowledges at a time, and
/// each router on its route reserves room for this number. So a packet whose turn comes passes the link, every packet
/// gets its turn, and every packet arrives, whatever the processes do. A channel waits only for its own processes.
///
/// If a link loses part of a packet (link_faults.hpp), or a processor halts, packets stop there for ever, because
/// routers do not repeat them. The channels of these packets wait for ever; other channels continue.
class Router {
public:
    /// Makes a router on the processor `executive`. Null means an infinitely fast processor. Throws std::logic_error if
    /// the handling is negative.
    explicit Router(Kernel&, Executive* executive, const RouterCosts& = {});
    Router(const Router&) = delete;
    Router& operator=(const Router&) = delete;

    /// Return the number of packets that were passed on from one link to another, and their cost to the processor,
    /// including instructions. The cost does not include the interrupts of other processes. A packet causes at most two
    /// of them, one when it comes and one when it has gone.
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

/// A link, or a path over a bus, between two routers. Channels travel over it in packets. REQUIRES: nothing else uses
/// the link.
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

/// A channel that travels in packets over one or more links. It is a rendezvous like any other channel: the outputting
/// process continues when the acknowledge of its last packet has returned. A packet is acknowledged when the inputting
/// process takes it. Until then the packet waits at the receiving end, so a channel with a late receiver does not block
/// other channels.
class Route final : public Carrier {
public:
    static constexpr std::size_t most_under_way = 4; ///< ours: largest number of packets sent and not yet acknowledged
    /// The memory that each processor on the route reserves for the channel, in bytes. Both ends are included.
    static constexpr std::int64_t room = most_under_way * (RouterPacket::header_bytes + RouterPacket::most_bytes);

    /// REQUIRES: there is at least one hop, each hop begins at the router where the previous hop ends, and no hop
    /// occurs twice.
    Route(Kernel&, const std::vector<Hop>&);

    void output(AnyChannel&, const WireForm&, const SourceLocation&) override;
    void input(AnyChannel&, const SourceLocation&) override;
    bool message_waits(const AnyChannel&) const override { return !here_.empty(); }
    std::string why_not_given_up() const override { return "travels in packets, which routers carry to their end"; }
    /// Returns whether a packet of the current message, or its acknowledge, is stopped.
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

    /// Advances the packet, which has arrived over a link. Returns the port that sends it on, or null if its route ends
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
