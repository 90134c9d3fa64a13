#pragma once

#include "runtime/hardware/link_faults.hpp"
#include "runtime/hardware/link_timing.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace placedpar::test {

/// The traffic in one direction of a link: messages or transfers, each after a pause.
struct Traffic {
    struct Message {
        std::int64_t sender_pause, receiver_pause; ///< nanoseconds
        std::vector<std::uint32_t> parts;          ///< bytes
        bool alternates = false;                   ///< the receiver asks for the message only when the first byte has
                                                   ///< arrived
    };
    /// A number of bytes that one end gives or takes. The counts at the two ends need not agree. A transfer ends when
    /// its own bytes have passed, and the next one at this end may begin in the middle of a transfer of the other end.
    struct Transfer {
        std::int64_t pause; ///< nanoseconds since the previous transfer ended
        std::uint32_t bytes;
        bool alternates = false;  ///< the receiver asks for the transfer only when a byte has arrived
        bool ends_message = true; ///< false: the transfer is a part of a message but not its last, and its end is not
                                  ///< in the Course
    };
    std::vector<Message> messages;
    std::vector<Transfer> given, taken; ///< REQUIRES: empty if there are messages
};

/// The times at which outputs and inputs of the messages, or transfers, ended, in nanoseconds.
struct Course {
    std::vector<std::int64_t> output_ended, input_ended;
    bool operator==(const Course&) const = default;
};

/// Models a link as a clocked circuit, one nanosecond a step: levels on two wires, and packets decoded from the levels.
/// It shares only the figures of LinkTiming with the runtime, and serves as the reference for
/// runtime/hardware/link.cpp, which uses events. A message is a sequence of transfers, one for each part, whose counts
/// agree at both ends.
class BitModel {
public:
    /// A packet: a byte or an acknowledge.
    struct Packet {
        std::int64_t began; ///< nanoseconds
        std::size_t wire;   ///< 0: it left a; 1: it left b
        bool acknowledge, lost;
        bool operator==(const Packet&) const = default;
    };

    /// REQUIRES: the wire's delay, the latencies and the limits of the faults are whole nanoseconds.
    BitModel(const hardware::LinkTiming&, const std::array<Traffic, 2>&, const std::vector<hardware::LinkFault>& = {});
    /// Steps until all traffic has passed. Throws if this takes longer than the limit.
    std::array<Course, 2> run(std::int64_t limit);
    /// Steps up to and including this time.
    std::array<Course, 2> run_until(std::int64_t end);
    /// Steps until nothing more can happen: all traffic has passed, or the link is stuck. Throws if this takes longer
    /// than the limit.
    std::array<Course, 2> run_until_quiet(std::int64_t limit);

    /// Replaces the faults from the next step on. A copy of the model can thus continue with other faults.
    void suffer(const std::vector<hardware::LinkFault>& faults) { faults_ = faults; }

    /// Returns the packets in the order in which they began.
    const std::vector<Packet>& packets() const { return packets_; }
    /// Returns when bytes of direction 0 (from a to b) or 1 arrived unasked for, so that an alternation could see them.
    const std::vector<std::int64_t>& byte_waited(std::size_t direction) const {
        return receiver_[direction].byte_waited;
    }
    /// Whether such a byte is waiting now.
    bool byte_waits(std::size_t direction) const { return receiver_[direction].arrived > receiver_[direction].asked; }
    /// Returns the bytes whose acknowledges have reached the sender, or (below) that have arrived completely.
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
        std::size_t transfer = 0; ///< the current transfer, or the next one
        std::uint32_t to_start = 0;
        std::uint64_t acknowledged = 0; ///< bytes
        bool sending = false, awaits_acknowledge = false;
        std::int64_t may_start = 0, ends_at = -1, wakes_at = 0;
        bool is_done() const { return transfer == transfers.size(); }
    };
    struct Receiver {
        std::vector<Traffic::Transfer> transfers;
        std::size_t transfer = 0;                       ///< the current transfer, or the next one
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
    // Direction d leads from end d to the other. Its sender, its receiver and the transmitter of its bytes have index
    // d; the other transmitter sends its acknowledges.
    std::array<Transmitter, 2> transmitter_;
    std::array<Decoder, 2> decoder_; ///< indexed by the wire that they read
    std::array<Sender, 2> sender_;
    std::array<Receiver, 2> receiver_;
    std::array<Course, 2> course_;
    std::vector<Packet> packets_;
};

} // namespace placedpar::test
