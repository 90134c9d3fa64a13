#pragma once

#include "runtime/event.hpp"
#include "runtime/hardware/link_packets.hpp"
#include "runtime/hardware/link_timing.hpp"
#include "runtime/time.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace placedpar::hardware {

/// What happens on a link next, in one of its directions.
enum class LinkStep : std::uint8_t {
    acknowledge_begins,
    byte_begins,
    byte_is_noticed,    ///< by a receiver that has not asked for it
    register_is_free,   ///< for the next byte of a program that writes the link byte by byte
    first_byte_arrives, ///< of a part, whole
    last_byte_arrives,  ///< of a part, whole
    sending_ends,       ///< the acknowledge of the last byte of a part has arrived
    falls_silent        ///< nothing: but the link was busy until then, which may be the end of a run that gets stuck
};

/// The state of a link at a moment, and the one rule by which it changes. It is a value: a copy of it can be run ahead
/// to find out what will happen, if nobody acts on the link before.
///
/// A byte travels, is noticed after a while and, if its receiver has asked for it, acknowledged; the acknowledge lets
/// the next byte start. The part of a message ends for its receiver when its last byte has arrived, and for its sender
/// when the acknowledge of that has.
struct LinkState {
    /// What a direction does.
    enum class Phase : std::uint8_t {
        idle,             ///< no packet is to come; a byte may be sent at the moment `at` or later
        travels,          ///< a byte or an acknowledge is to come, as `packets` says
        taken,            ///< the last byte of the part was delivered; its acknowledge is to come
        unnoticed,        ///< a byte is on its way to a receiver that has not asked for it, noticed at the moment `at`
        owed,             ///< that was noticed; its acknowledge is sent when the receiver asks
        restarts,         ///< the program that writes it may write the next byte at the moment `at`
        byte_lost,        ///< the byte begun last does not come over, and nothing follows
        acknowledge_lost, ///< the same for its acknowledge
        broken_off        ///< the receiver has given up the message under way: nothing more of it travels
    };
    enum class Receiver : std::uint8_t { absent, waits };
    /// The first byte of a part for which its receiver had not asked.
    enum class FirstByte : std::uint8_t { asked_for, waits };
    /// Whether both ends are in the same message. One of them may have given it up in the middle.
    enum class Ends : std::uint8_t { agree, receiver_left, sender_left };
    /// What moves the bytes at an end: an engine, parts of messages; or a program, each byte.
    enum class User : std::uint8_t { engine, program };

    struct Direction {
        Phase phase = Phase::idle;
        Receiver receiver = Receiver::absent;
        FirstByte first_byte = FirstByte::asked_for;
        Ends ends = Ends::agree;
        User sender_is = User::engine, receiver_is = User::engine;
        std::uint32_t part_bytes = 0; ///< length of the part under way; 0 between two parts
        Time at{};                    ///< see Phase
    };

    LinkPackets packets;
    std::array<Direction, 2> directions;
    bool lasts_too_long = false;   ///< something would come after the end of virtual time
    bool may_lose_packets = false; ///< it has faults, or leads through something that may stop packets
    /// Of each direction, in the order of an instant: first byte, last byte, last byte of the part after that (which
    /// can start before the last byte of this one has arrived), end of sending.
    /// At the end, of each wire: when a packet ends for which another waited that was withdrawn.
    static constexpr std::size_t arrivals_of_a_direction = 4, most_arrivals = 10;
    std::array<Time, most_arrivals> arrivals = {never, never, never, never, never, never, never, never, never, never};

    /// A step that is to come: when, and its order among those of an instant.
    struct Next {
        LinkStep step = LinkStep::falls_silent;
        std::uint8_t direction = 0;
        std::uint8_t order = 0;
        Time at = never;
        EventQueue::Priority priority() const { return static_cast<EventQueue::Priority>(order / ranks); }
        std::uint64_t rank() const { return order % ranks; }
    };
    static constexpr std::uint8_t ranks = 8; ///< of one priority, for one link
    /// The first one if nobody acts on the link before. Its order in an instant: requests for a wire, then packets that
    /// begin (of two for one wire the acknowledge), then arrivals.
    Next next() const;
    /// The next packet of a direction; any time if there is none: never.
    Next next_packet(std::size_t direction) const;

    /// What becomes of a packet that begins.
    enum class Fate : std::uint8_t { comes_over, is_lost };
    struct Outcome {
        bool delivers = false; ///< the receiver has the part from now on
        bool wakes = false;    ///< the receiver, who waited for the arrival of its end
        bool loses = false;    ///< the packet that has begun
    };
    /// Takes the step. REQUIRES: it is next(), or the next packet of its direction.
    Outcome take(const Next&, const PacketTimes&, Fate = Fate::comes_over);

    /// Its packets have run by themselves, up to the last byte of a part at most, since these were left.
    void note_last_bytes(const std::array<std::uint32_t, 2>& bytes_left_before, const PacketTimes&);
    std::array<std::uint32_t, 2> bytes_left() const {
        return {packets.streams[0].bytes_left, packets.streams[1].bytes_left};
    }

    // What the two ends do to it, at the moment packets.now.

    /// A packet is asked for now.
    void ask_for_byte(std::size_t direction, Time due);
    void ask_for_acknowledge(std::size_t direction, Phase phase, Time due);
    /// The earliest moment at which a byte may be sent.
    Time may_start(std::size_t direction) const;
    /// The packet that comes next in a direction is not sent after all.
    void withdraw_packet(std::size_t direction);
    /// The last byte begun will arrive, and the end waits for it.
    void expect_first_byte(std::size_t direction, const PacketTimes& times) {
        expect(first(direction), later(packets.streams[direction].last_start, times.arrival()));
    }
    void expect_last_byte(std::size_t direction, const PacketTimes&);
    void drop_first_byte(std::size_t direction) { arrivals[first(direction)] = never; }
    bool expects_first_byte(std::size_t direction) const { return arrivals[first(direction)] != never; }
    void drop_last_bytes(std::size_t direction) { arrivals[last(direction)] = arrivals[last(direction) + 1] = never; }
    /// That of the part under way.
    void drop_last_byte(std::size_t direction);
    void drop_end_of_sending(std::size_t direction) { arrivals[end_of_sending(direction)] = never; }
    bool expects_end_of_sending(std::size_t direction) const { return arrivals[end_of_sending(direction)] != never; }
    bool expects_last_byte(std::size_t direction) const { return arrivals[last(direction)] != never; }

    /// Whether the byte begun last has an acknowledge that has not begun.
    bool is_unacknowledged(std::size_t direction) const;
    /// The receiver is certain to take a first byte that begins now, and one that still waits for the end of the part
    /// before may not be.
    bool is_sure_of_receiver(std::size_t direction) const {
        return directions[direction].receiver == Receiver::waits && !expects_last_byte(direction);
    }
    /// Up to when packets may run by themselves, of those that this direction has yet to send: to the first that calls
    /// for more than its times.
    Time runs_before(std::size_t direction, const PacketTimes&) const;
    /// Its place.
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
