#pragma once

#include "runtime/hardware/link_faults.hpp"
#include "runtime/hardware/link_timing.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace placedpar::test {

/// What the two processes of one direction of a link do: message after message, each after a pause.
struct Traffic {
    struct Message {
        std::int64_t sender_pause, receiver_pause; ///< nanoseconds
        std::vector<std::uint32_t> parts;          ///< bytes
        bool alternates = false;                   ///< the receiver asks only once the first byte has arrived
    };
    std::vector<Message> messages;
};

/// When the outputs and the inputs of the messages ended, in nanoseconds.
struct Course {
    std::vector<std::int64_t> output_ended, input_ended;
    bool operator==(const Course&) const = default;
};

/// A link as a clocked circuit, stepped nanosecond by nanosecond: levels on two wires, packets decoded from
/// the levels, nothing shared with the runtime but the figures of LinkTiming. The other half of the test of
/// runtime/hardware/link.cpp: there events, here levels.
class BitModel {
public:
    BitModel(const hardware::LinkTiming&, const std::array<Traffic, 2>&, const std::vector<hardware::LinkFault>& = {});
    /// Steps until all traffic has passed. Throws when that takes longer than the limit.
    std::array<Course, 2> run(std::int64_t limit);
    /// Steps until then.
    std::array<Course, 2> run_until(std::int64_t end);

private:
    struct Transmitter { ///< at one end, onto the wire that leaves it
        std::vector<bool> level;
        std::vector<bool> packet;
        std::int64_t packet_began = 0, idle_from = 0, bit = 0;
        bool acknowledge_wanted = false;
    };
    struct Decoder { ///< of the wire that comes in
        bool in_packet = false;
        std::int64_t began = 0, bits = 0, bit = 0;
    };
    struct Sender {
        std::size_t message = 0, part = 0;
        std::uint32_t to_start = 0;
        bool sending = false, awaits_acknowledge = false;
        std::int64_t may_start = 0, ends_at = -1, wakes_at = 0;
    };
    struct Receiver {
        std::size_t message = 0, part = 0;
        std::uint64_t asked = 0, seen = 0, arrived = 0; ///< bytes
        std::int64_t notice_at = -1, wakes_at = 0, arrives_at = -1;
        bool owed = false, receiving = false, alternating = false;
    };

    void decode(std::size_t end);
    void packet_known(std::size_t end, bool data);
    void notice(std::size_t end);
    void transmit(std::size_t end);
    void drive(std::size_t end);
    void processes(std::size_t direction);
    void timers(std::size_t direction);
    void begin_part(std::size_t direction);
    void begin_input(std::size_t direction);
    void ask_part(std::size_t direction);
    void next_output(std::size_t direction);
    void next_input(std::size_t direction);
    bool over() const;
    void step();
    std::int64_t bit_at(std::int64_t time) const;
    bool loses_packet(std::size_t end, bool acknowledge);

    std::int64_t bit_, delay_;
    bool overlapped_;
    std::vector<hardware::LinkFault> faults_;
    std::array<Traffic, 2> traffic_;
    std::int64_t now_ = 0;
    // Direction d goes from end d to the other: its sender and the transmitter of its bytes have index d,
    // its receiver too; the transmitter of its acknowledges is the other one.
    std::array<Transmitter, 2> transmitter_;
    std::array<Decoder, 2> decoder_; ///< index: the wire that it reads
    std::array<Sender, 2> sender_;
    std::array<Receiver, 2> receiver_;
    std::array<Course, 2> course_;
};

} // namespace placedpar::test
