#pragma once

#include "runtime/hardware/link_faults.hpp"
#include "runtime/hardware/link_timing.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace placedpar::test {

/// The traffic in one direction of a link: messages or transfers, with a pause before each.
struct Traffic {
    struct Message {
        std::int64_t sender_pause, receiver_pause; ///< nanoseconds
        std::vector<std::uint32_t> parts;          ///< bytes
        bool alternates = false;                   ///< the receiver asks for the message only after the first byte has
                                                   ///< arrived
    };
    /// A number of bytes that one end gives or takes. The counts at the two ends may differ. A transfer ends when its
    /// own bytes have passed. The next transfer at this end may begin in the middle of a transfer of the other end.
    struct Transfer {
        std::int64_t pause; ///< nanoseconds from the end of the previous transfer
        std::uint32_t bytes;
        bool alternates = false;  ///< the receiver asks for the transfer only after a byte has arrived
        bool ends_message = true; ///< false: the transfer is a part of a message but not the last, and the Course does
                                  ///< not include its end
    };
    std::vector<Message> messages;
    std::vector<Transfer> given, taken; ///< REQUIRES: empty if there are messages
};

/// The times at which outputs and inputs of messages or transfers ended, in nanoseconds.
struct Course {
    std::vector<std::int64_t> output_ended, input_ended;
    bool operator==(const Course&) const = default;
};

/// Models a link as a clocked circuit with steps of one nanosecond: levels on two wires, and packets decoded from the
/// levels. It shares only the figures of LinkTiming with the runtime. It is the reference for
/// runtime/hardware/link.cpp, which uses events. A message is a sequence of transfers, one for each part, with equal
/// counts at both ends.
class BitModel {
public:
    /// A packet: a byte or an acknowledge.
    struct Packet {
        std::int64_t began; ///< nanoseconds
        std::size_t wire;   ///< 0: the packet left a; 1: it left b
        bool acknowledge, lost;
        bool operator==(const Packet&) const = default;
    };

    /// REQUIRES: the wire's delay, the latencies and the limits of the faults are whole nanoseconds.
    BitModel(const hardware::LinkTiming&, const std::array<Traffic, 2>&, const std::vector<hardware::LinkFault>& = {});
    /// Steps until all traffic has passed. Throws if this takes longer than the limit.
    std::array<Course, 2> run(std::int64_t limit);
    /// Steps up to and including this time.
    std::array<Course, 2> run_until(std::int64_t end);
    /// Steps until nothing more can happen, because all traffic has passed or the link is stuck. Throws if this takes
    /// longer than the limit.
    std::array<Course, 2> run_until_quiet(std::int64_t limit);

    /// Replaces the faults from the next step on. So a copy of the model can continue with other faults.
    void suffer(const std::vector<hardware::LinkFault>& faults) { faults_ = faults; }

    /// Returns the packets in the order in which they began.
    const std::vector<Packet>& packets() const { return packets_; }
    /// Returns the times at which bytes of direction 0 (from a to b) or 1 arrived before the receiver asked for them,
    /// so that an alternation could see them.
    const std::vector<std::int64_t>& byte_waited(std::size_t direction) const {
        return receiver_[direction].byte_waited;
    }
    /// Returns whether such a byte is waiting now.
    bool byte_waits(std::size_t direction) const { return receiver_[direction].arrived > receiver_[direction].asked; }
    /// Return how many bytes have an acknowledge that reached the sender, and how many bytes have arrived completely.
    std::uint64_t bytes_acknowledged(std::size_t direction) const { return sender_[direction].acknowledged; }
    std::uint64_t bytes_arrived(std::size_t direction) const { return receiver_[direction].arrived; }

private:
    struct Transmitter { ///< sends from one end onto its outgoing wire
        std::vector<bool> level;
        std::vector<bool> packet;
        std::size_t bit_sent = 0; ///< index of the packet's current bit
        std::int64_t bit_ends = 0, idle_from = 0, bit = 0;
        bool acknowledge_wanted = false;
    };
    struct Decoder { ///< reads the incoming wire
        bool in_packet = false;
        std::int64_t began = 0, bits = 0, bit = 0;
    };
    struct Sender {
        std::vector<Traffic::Transfer> transfers;
        std::size_t transfer = 0; ///< current transfer, or the next one
        std::uint32_t to_start = 0;
        std::uint64_t acknowledged = 0; ///< bytes
        bool sending = false, awaits_acknowledge = false;
        std::int64_t may_start = 0, ends_at = -1, wakes_at = 0;
        bool is_done() const { return transfer == transfers.size(); }
    };
    struct Receiver {
        std::vector<Traffic::Transfer> transfers;
        std::size_t transfer = 0;                       ///< current transfer, or the next one
        std::uint64_t asked = 0, seen = 0, arrived = 0; ///< bytes
        std::int64_t notice_at = -1, wakes_at = 0, arrives_at = -1;
        bool owed = false, receiving = false, alternating = false;
        std::vector<std::int64_t> byte_waited;
        bool is_done() const { return transfer == transfers.size(); }
    };

    void decode(std::size_t end);
    void packet_known(std::size_t end, bool data);
    void notice(std::size_t end);
    void transmit(std::size_t end);
    void drive(std::size_t end);
    void byte_arrived(std::size_t direction);
    void begin_output(std::size_t direction);
    void give(std::size_t direction);
    void begin_input(std::size_t direction);
    void take(std::size_t direction);
    void given(std::size_t direction);
    void taken(std::size_t direction);
    bool over() const;
    bool is_quiet() const;
    void step();
    std::int64_t bit_at(std::int64_t time) const;
    bool loses_packet(std::size_t end, bool acknowledge);

    std::int64_t bit_, delay_;
    bool overlapped_;
    std::vector<hardware::LinkFault> faults_;
    std::int64_t now_ = 0;
    // Direction d leads from end d to the other end. The sender and the receiver of direction d, and the transmitter of
    // its bytes, have index d. The other transmitter sends its acknowledges.
    std::array<Transmitter, 2> transmitter_;
    std::array<Decoder, 2> decoder_; ///< indexed by the wire that they read
    std::array<Sender, 2> sender_;
    std::array<Receiver, 2> receiver_;
    std::array<Course, 2> course_;
    std::vector<Packet> packets_;
};

} // namespace placedpar::test
