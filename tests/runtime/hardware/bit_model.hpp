#pragma once

#include "runtime/hardware/link_faults.hpp"
#include "runtime/hardware/link_timing.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace placedpar::test {

/// What the two ends of one direction of a link do: message after message, or transfer after transfer, each after a
/// pause.
struct Traffic {
    struct Message {
        std::int64_t sender_pause, receiver_pause; ///< nanoseconds
        std::vector<std::uint32_t> parts;          ///< bytes
        bool alternates = false;                   ///< the receiver asks only once the first byte has arrived
    };
    /// So many bytes that one end gives or takes. The other end need not take or give as many: a transfer ends when its
    /// own bytes have passed, and the next one at this end goes on in the middle of the other end's.
    struct Transfer {
        std::int64_t pause; ///< nanoseconds since the transfer before ended
        std::uint32_t bytes;
        bool alternates = false;  ///< the receiver asks only once a byte has arrived
        bool ends_message = true; ///< false: a part of a message that is not its last; the Course leaves out its end
    };
    std::vector<Message> messages;
    std::vector<Transfer> given, taken; ///< REQUIRES: empty if there are messages
};

/// When the outputs and the inputs of the messages, or the transfers, ended, in nanoseconds.
struct Course {
    std::vector<std::int64_t> output_ended, input_ended;
    bool operator==(const Course&) const = default;
};

/// A link as a clocked circuit, stepped nanosecond by nanosecond: levels on two wires, packets decoded from
/// the levels, nothing shared with the runtime but the figures of LinkTiming. The other half of the test of
/// runtime/hardware/link.cpp: there events, here levels.
///
/// A message is a row of transfers, one for each part, whose counts agree at both ends.
class BitModel {
public:
    /// A packet: a byte or an acknowledge.
    struct Packet {
        std::int64_t began; ///< nanoseconds
        std::size_t wire;   ///< 0: it left a; 1: it left b
        bool acknowledge, lost;
        bool operator==(const Packet&) const = default;
    };

    /// REQUIRES: the wire's delay and the edges of the faults are whole nanoseconds, and so are the latencies.
    BitModel(const hardware::LinkTiming&, const std::array<Traffic, 2>&, const std::vector<hardware::LinkFault>& = {});
    /// Steps until all traffic has passed. Throws when that takes longer than the limit.
    std::array<Course, 2> run(std::int64_t limit);
    /// Steps until then, which is still done.
    std::array<Course, 2> run_until(std::int64_t end);
    /// Steps until nothing can happen any more: all traffic has passed, or the link is stuck. Throws when that takes
    /// longer than the limit.
    std::array<Course, 2> run_until_quiet(std::int64_t limit);

    /// From the next step on it has these faults, and no others. A copy of a model that has gone so far can go on with
    /// other faults than the model.
    void suffer(const std::vector<hardware::LinkFault>& faults) { faults_ = faults; }

    /// In the order in which they began.
    const std::vector<Packet>& packets() const { return packets_; }
    /// When bytes of direction 0, from a to b, or 1 had arrived for which nothing had asked, so that an alternation
    /// could see them.
    const std::vector<std::int64_t>& byte_waited(std::size_t direction) const {
        return receiver_[direction].byte_waited;
    }
    /// Whether such a byte is there now.
    bool byte_waits(std::size_t direction) const { return receiver_[direction].arrived > receiver_[direction].asked; }
    /// Bytes whose acknowledge has come back to the sender, and bytes that have arrived whole.
    std::uint64_t bytes_acknowledged(std::size_t direction) const { return sender_[direction].acknowledged; }
    std::uint64_t bytes_arrived(std::size_t direction) const { return receiver_[direction].arrived; }

private:
    struct Transmitter { ///< at one end, onto the wire that leaves it
        std::vector<bool> level;
        std::vector<bool> packet;
        std::size_t bit_sent = 0; ///< of the packet, now
        std::int64_t bit_ends = 0, idle_from = 0, bit = 0;
        bool acknowledge_wanted = false;
    };
    struct Decoder { ///< of the wire that comes in
        bool in_packet = false;
        std::int64_t began = 0, bits = 0, bit = 0;
    };
    struct Sender {
        std::vector<Traffic::Transfer> transfers;
        std::size_t transfer = 0; ///< the one under way, or the next one
        std::uint32_t to_start = 0;
        std::uint64_t acknowledged = 0; ///< bytes
        bool sending = false, awaits_acknowledge = false;
        std::int64_t may_start = 0, ends_at = -1, wakes_at = 0;
        bool is_done() const { return transfer == transfers.size(); }
    };
    struct Receiver {
        std::vector<Traffic::Transfer> transfers;
        std::size_t transfer = 0;                       ///< the one under way, or the next one
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
    // Direction d goes from end d to the other: its sender and the transmitter of its bytes have index d,
    // its receiver too; the transmitter of its acknowledges is the other one.
    std::array<Transmitter, 2> transmitter_;
    std::array<Decoder, 2> decoder_; ///< index: the wire that it reads
    std::array<Sender, 2> sender_;
    std::array<Receiver, 2> receiver_;
    std::array<Course, 2> course_;
    std::vector<Packet> packets_;
};

} // namespace placedpar::test
