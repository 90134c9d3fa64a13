#pragma once

#include "runtime/event.hpp"
#include "runtime/hardware/link_packets.hpp"
#include "runtime/hardware/link_timing.hpp"
#include "runtime/time.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace placedpar::hardware {

/// The steps by which a link changes. Each belongs to one of its two directions.
enum class LinkStep : std::uint8_t {
    acknowledge_begins,
    byte_begins,
    byte_is_noticed,    ///< the receiving end, which has not asked for the byte, notices it
    register_is_free,   ///< a program that writes each byte may write the next one
    first_byte_arrives, ///< the whole first byte of a part has arrived
    last_byte_arrives,  ///< the whole last byte of a part has arrived
    sending_ends,       ///< the acknowledge of the last byte of a part has arrived
    falls_silent        ///< the link was busy until now, which may be the time at which a stuck run ends
};

/// The state of a link at a moment, and the one rule by which it changes. It is a value: a copy can be run ahead to
/// find out what will happen unless a process or a fault acts on the link earlier.
///
/// A byte travels. The receiving end notices it after a latency and, if a receiver has asked for the byte, acknowledges
/// it; the acknowledge lets the next byte start. A message travels in one part or several. A part ends for its receiver
/// when its last byte has arrived, and for its sender when the acknowledge of that byte has arrived.
struct LinkState {
    /// What a direction is doing.
    enum class Phase : std::uint8_t {
        idle,             ///< no packet is due; a byte may be sent at the time `at` or later
        travels,          ///< a byte or an acknowledge is due, as `packets` says
        delivered,        ///< the receiver has the last byte of the part; the acknowledge of that byte is due
        unnoticed,        ///< a byte travels to a receiver that has not asked for it; it is noticed at the time `at`
        owed,             ///< such a byte was noticed; its acknowledge is sent when the receiver asks
        restarts,         ///< the program that writes the bytes may write the next one at the time `at`
        byte_lost,        ///< the last byte sent is lost, and nothing follows
        acknowledge_lost, ///< the acknowledge of the last byte sent is lost, and nothing follows
        broken_off        ///< the receiver has given up the message under way; nothing more of it travels
    };
    enum class Receiver : std::uint8_t { absent, waits };
    /// Whether the first byte of a part has arrived before its receiver asked for it.
    enum class FirstByte : std::uint8_t { asked_for, waits };
    /// Whether both ends are in the same message, or one has given it up in the middle.
    enum class Ends : std::uint8_t { agree, receiver_left, sender_left };
    /// What moves the bytes at an end: an engine moves whole parts, a program each byte.
    enum class User : std::uint8_t { engine, program };

    struct Direction {
        Phase phase = Phase::idle;
        Receiver receiver = Receiver::absent;
        FirstByte first_byte = FirstByte::asked_for;
        Ends ends = Ends::agree;
        User sender_is = User::engine, receiver_is = User::engine;
        std::uint32_t part_bytes = 0; ///< length of the part under way; 0 between two parts
        Time at{};                    ///< a time that Phase explains
    };

    LinkPackets packets;
    std::array<Direction, 2> directions;
    bool lasts_too_long = false;   ///< a step would come after the end of virtual time, which ends the run
    bool may_lose_packets = false; ///< the link has faults, or leads through a switch that may stop packets
    /// When something arrives; `never` if nothing will. Each direction has four entries, in the order in which
    /// simultaneous ones happen: first byte, last byte, last byte of the following part (which can start before the
    /// last byte of this part has arrived), end of sending. The last two entries belong to the wires: the end of a
    /// packet that another packet waited for until it was withdrawn.
    static constexpr std::size_t arrivals_of_a_direction = 4, most_arrivals = 10;
    std::array<Time, most_arrivals> arrivals = {never, never, never, never, never, never, never, never, never, never};

    /// A step that has not happened yet, its time, and its order among the steps of that time.
    struct Next {
        LinkStep step = LinkStep::falls_silent;
        std::uint8_t direction = 0;
        std::uint8_t order = 0;
        Time at = never;
        EventQueue::Priority priority() const { return static_cast<EventQueue::Priority>(order / ranks); }
        std::uint64_t rank() const { return order % ranks; }
    };
    static constexpr std::uint8_t ranks = 8; ///< how many ranks a link has within one priority
    /// Returns the first step that happens unless a process or a fault acts on the link earlier. Order of simultaneous
    /// steps: requests for a wire, then packets that begin (an acknowledge before a byte on the same wire), then
    /// arrivals.
    Next next() const;
    /// Returns the next packet of a direction. Its time is `never` if there is none.
    Next next_packet(std::size_t direction) const;

    /// Whether a packet that begins reaches the other end.
    enum class Fate : std::uint8_t { comes_over, is_lost };
    struct Outcome {
        bool delivers = false; ///< the receiver has the part from now on
        bool wakes = false;    ///< the receiver waited for the last byte, and goes on
        bool is_lost = false;  ///< the packet that has begun is lost
    };
    /// Performs the step. REQUIRES: it is next(), or the next packet of its direction.
    Outcome perform(const Next&, const PacketTimes&, Fate = Fate::comes_over);

    /// Call after packets have run by themselves, with the bytes that were left before: notes the arrival of last
    /// bytes. REQUIRES: they ran no further than the last byte of a part.
    void note_last_bytes(const std::array<std::uint32_t, 2>& bytes_left_before, const PacketTimes&);
    std::array<std::uint32_t, 2> bytes_left() const {
        return {packets.streams[0].bytes_left, packets.streams[1].bytes_left};
    }

    // The rest is what the two ends do to the state, at the time packets.now.

    /// Asks for the next packet. It begins at the time `due`, or when its wire is free.
    void ask_for_byte(std::size_t direction, Time due);
    void ask_for_acknowledge(std::size_t direction, Phase phase, Time due);
    /// Returns the earliest time at which a byte may be sent.
    Time may_start(std::size_t direction) const;
    /// Withdraws the next packet of a direction, and puts the direction into that phase.
    void stop(std::size_t direction, Phase);
    /// Expects the arrival of the last byte sent, which is the first of its part.
    void expect_first_byte(std::size_t direction, const PacketTimes& times) {
        expect(first(direction), later(packets.streams[direction].last_start, times.arrival()));
    }
    void expect_last_byte(std::size_t direction, const PacketTimes&);
    void drop_first_byte(std::size_t direction) { arrivals[first(direction)] = never; }
    bool expects_first_byte(std::size_t direction) const { return arrivals[first(direction)] != never; }
    void drop_last_bytes(std::size_t direction) { arrivals[last(direction)] = arrivals[last(direction) + 1] = never; }
    /// Drops the arrival of the last byte of the part under way, and keeps that of the part before.
    void drop_last_byte(std::size_t direction);
    void drop_end_of_sending(std::size_t direction) { arrivals[end_of_sending(direction)] = never; }
    bool expects_end_of_sending(std::size_t direction) const { return arrivals[end_of_sending(direction)] != never; }
    bool expects_last_byte(std::size_t direction) const { return arrivals[last(direction)] != never; }

    /// Whether the acknowledge of the last byte sent has not begun.
    bool is_unacknowledged(std::size_t direction) const;
    /// Whether the receiver is certain to take a first byte that begins now. A receiver that still waits for the end of
    /// the part before is not.
    bool is_sure_of_receiver(std::size_t direction) const {
        return directions[direction].receiver == Receiver::waits && !expects_last_byte(direction);
    }
    /// Packets that begin earlier than the returned time need nothing but their times worked out, as far as this
    /// direction is concerned.
    Time runs_before(std::size_t direction, const PacketTimes&) const;
    /// Returns the index of the earliest entry of `arrivals`.
    std::size_t first_arrival() const;

private:
    static constexpr std::size_t first(std::size_t direction) { return direction * arrivals_of_a_direction; }
    static constexpr std::size_t last(std::size_t direction) { return first(direction) + 1; }
    static constexpr std::size_t silence(std::size_t wire) { return 2 * arrivals_of_a_direction + wire; }
    static constexpr std::size_t end_of_sending(std::size_t direction) { return first(direction) + 3; }
    void expect(std::size_t arrival, Time at) {
        arrivals[arrival] = at;
        lasts_too_long = lasts_too_long || at == never;
    }
    bool is_first_byte_foreseen(std::size_t direction, const PacketTimes& times) const {
        return is_sure_of_receiver(direction) && times.overlaps() && !may_lose_packets;
    }
    Outcome begin_byte(std::size_t direction, const PacketTimes&, Fate);
    Outcome begin_acknowledge(std::size_t direction, const PacketTimes&, Fate);
    Outcome last_byte_arrives(std::size_t direction);
};

} // namespace placedpar::hardware
