#pragma once

#include "runtime/carrier.hpp"
#include "runtime/channel.hpp"
#include "runtime/hardware/link.hpp"
#include "runtime/process.hpp"
#include "runtime/source_location.hpp"

#include <cstdint>
#include <deque>
#include <list>
#include <string>

namespace placedpar {
class Executive;
class Kernel;
} // namespace placedpar

namespace placedpar::hardware {

/// Several channels over one link, by virtual channels: at each end of the link two high-priority processes
/// send and receive packets. A message is one packet; it waits at the receiving end until the inputting
/// process takes it, then an acknowledge packet goes back and the outputting process goes on. So a channel
/// whose receiver is late does not stop the others, and a communication is still a rendezvous.
///
/// This costs the link a header on each packet, and the two executives cycles for each packet sent and received.
class Multiplexer {
public:
    static constexpr std::uint32_t header_bytes = 4; ///< ours: one word names the channel and the kind of packet
    static constexpr Cycles packet_handling{200};    ///< ours: queueing, looking up the channel, rescheduling

    /// `a` and `b` execute its processes; null ones are infinitely fast. REQUIRES: nothing else uses the link.
    Multiplexer(Kernel&, const std::string& name, Link&, Executive* a, Executive* b);
    /// A carrier for one more channel.
    Carrier& add_channel(bool from_a_to_b);

private:
    class Lane;
    struct Packet {
        Lane* lane;
        bool acknowledge;
        std::int64_t bytes;
        WireForm wire_form() const { return WireForm(header_bytes + bytes); }
    };

    /// The two processes at one end, and the packets that wait to be sent.
    class End {
    public:
        End(Kernel&, const std::string& name, Executive*, Channel<Packet>& out, Channel<Packet>& in);
        void post(const Packet&);

    private:
        void send_packets();
        void receive_packets();

        Channel<Packet>& out_;
        Channel<Packet>& in_;
        std::deque<Packet> queue_;
        bool sender_idle_ = false; ///< it waits for a packet to send
        Process sender_, receiver_;
    };

    /// One of the channels that share the link.
    class Lane final : public Carrier {
    public:
        Lane(End& near, End& far) : near_(near), far_(far) {}
        void output(AnyChannel&, const WireForm&, const SourceLocation&) override;
        void input(AnyChannel&, const SourceLocation&) override;
        bool message_waits(const AnyChannel&) const override { return message_here_; }
        void packet_came(const Packet&);

    private:
        void take_message();

        End& near_; ///< where the outputting process is
        End& far_;  ///< where the inputting process is
        AnyChannel* channel_ = nullptr;
        Process* outputter_ = nullptr; ///< of the message under way
        Process* inputter_ = nullptr;  ///< while it waits
        bool message_here_ = false;    ///< it has arrived, and no process has taken it
    };

    Channel<Packet> a_to_b_, b_to_a_;
    End a_, b_;
    std::list<Lane> lanes_;
};

} // namespace placedpar::hardware
