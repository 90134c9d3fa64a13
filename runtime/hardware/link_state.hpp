#pragma once

#include "runtime/event.hpp"
#include "runtime/hardware/link_packets.hpp"
#include "runtime/hardware/link_timing.hpp"
#include "runtime/time.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace placedpar::hardware {

/// The steps by which a link changes. Each step belongs to one of the two directions.
enum class LinkStep : std::uint8_t {
    acknowledge_begins,
    byte_begins,
    byte_is_noticed,    ///< the receiving end notices a byte for which no receiver waits
    register_is_free,   ///< a program that writes each byte may now write the next one
    first_byte_arrives, ///< the first byte of a part has arrived completely
    last_byte_arrives,  ///< the last byte of a part has arrived completely
    sending_ends,       ///< the acknowledge of the last byte of a part has arrived
    falls_silent        ///< the link was busy until now; a stuck run may end at this time
};

/// The state of a link at a moment, and the rule by which the state changes. LinkCourse copies the state and runs the
/// copy ahead, to find out what happens if no process and no fault acts on the link.
///
/// When a byte travels, the receiving end notices it after a latency, and acknowledges it if a receiver waits. After
/// the acknowledge the next byte can start. A packet is a byte or an acknowledge. A message travels in one or several
/// parts. A part ends for its receiver when its last byte has arrived, and for its sender when the acknowledge of this
/// byte has arrived.
struct alignas(64) LinkState {
    /// The activity of a direction.
    enum class Phase : std::uint8_t {
        idle,             ///< no packet is due; a byte may be sent from the time `at` on
        travels,          ///< a byte or an acknowledge is due, see `packets`
        delivered,        ///< the receiver has the last byte of the part; its acknowledge is due
        unnoticed,        ///< a byte travels for which no receiver waits; it is noticed at the time `at`
        owed,             ///< a byte was noticed for which no receiver waits; its acknowledge waits for a receiver
        restarts,         ///< the program that writes the bytes may write the next one from the time `at` on
        byte_lost,        ///< the last byte that was sent is lost; no packet follows
        acknowledge_lost, ///< the acknowledge of the last byte that was sent is lost; no packet follows
        broken_off        ///< the receiver has given up the current message; no packet of it follows
    };
    enum class Receiver : std::uint8_t { absent, waits };
    /// States whether the first byte of a part arrived before a receiver waited for it.
    enum class FirstByte : std::uint8_t { asked_for, waits };
    /// States whether both ends are in the same message, or one of them has left it in the middle.
    enum class Ends : std::uint8_t { agree, receiver_left, sender_left };
    /// The user of an end: an engine of a transputer, which moves whole parts, or a program, which moves each byte.
    enum class User : std::uint8_t { engine, program };

    struct Direction {
        Phase phase = Phase::idle;
        Receiver receiver = Receiver::absent;
        FirstByte first_byte = FirstByte::asked_for;
        Ends ends = Ends::agree;
        std::uint32_t part_bytes = 0; ///< length of the current part; 0 between two parts
        Time at{};                    ///< a time, whose meaning depends on the phase
    };
    struct Users {
        User sender = User::engine, receiver = User::engine;
    };

    LinkPackets packets;
    std::array<Direction, 2> directions;
    /// The times of arrivals; `never` if nothing will arrive. Each direction has three entries: first byte, last byte,
    /// end of sending. Simultaneous arrivals happen in the order of the entries.
    static constexpr std::size_t arrivals_of_a_direction = 3, most_arrivals = 6;
    std::array<Time, most_arrivals> arrivals = {never, never, never, never, never, never};
    /// For each direction, when the last byte of the next part arrives. The next part can begin before the last byte of
    /// the current part has arrived.
    std::array<Time, 2> last_bytes_after = {never, never};
    Time busy_until{}; ///< end of the packets on the wires, in case no step comes later; set if a waiting packet is
                       ///< withdrawn
    std::array<Users, 2> users;
    bool may_lose_packets = false; ///< the link has faults, or leads through a device that may stop packets

    /// A step that has not happened yet, with its time and its order among simultaneous steps.
    struct Next {
        LinkStep step = LinkStep::falls_silent;
        std::uint8_t direction = 0;
        std::uint8_t order = 0;
        Time at = never;
        EventQueue::Priority priority() const { return static_cast<EventQueue::Priority>(order / ranks); }
        std::uint64_t rank() const { return order % ranks; }
    };
    static constexpr std::uint8_t ranks = 8; ///< number of ranks that a link has within one priority
    /// Returns the next step that the link makes by itself. Of simultaneous steps, requests for a wire come first, then
    /// packets that begin (an acknowledge before a byte on the same wire), then arrivals.
    Next next() const;
    /// Returns the next packet of a direction. Its time is `never` if there is no next packet.
    Next next_packet(std::size_t direction) const;

    /// States whether a packet that begins will reach the other end.
    enum class Fate : std::uint8_t { comes_over, is_lost };
    struct Outcome {
        bool delivers = false; ///< the receiver now has the part
        bool wakes = false;    ///< the receiver waited for the last byte, and continues
        bool is_lost = false;  ///< the packet that began is lost
    };
    /// Performs the step. REQUIRES: the step is next() or the next packet of its direction.
    Outcome perform(const Next&, const PacketTimes&, Fate = Fate::comes_over);

    /// Schedules the arrivals of last bytes after several packets were computed together. `bytes_left_before` is the
    /// result of bytes_left() before these packets. REQUIRES: the packets ended at the last byte of a part or before.
    void note_last_bytes(const std::array<std::uint32_t, 2>& bytes_left_before, const PacketTimes&);
    std::array<std::uint32_t, 2> bytes_left() const {
        return {packets.streams[0].bytes_left, packets.streams[1].bytes_left};
    }

    // The following functions change the state on behalf of the two ends, at the time packets.now.

    /// Request the next packet. It begins at the time `due`, or later when its wire is free.
    void ask_for_byte(std::size_t direction, Time due);
    void ask_for_acknowledge(std::size_t direction, Phase phase, Time due);
    /// Returns the earliest time at which a byte may be sent.
    Time may_start(std::size_t direction) const;
    /// Withdraws the next packet of a direction, and sets the phase of the direction.
    void stop(std::size_t direction, Phase);
    /// Schedules the arrival of the last byte that began, which is the first byte of its part.
    void expect_first_byte(std::size_t direction, const PacketTimes& times) {
        arrivals[first(direction)] = time_of_step(packets.streams[direction].last_start, times.arrival());
    }
    void expect_last_byte(std::size_t direction, const PacketTimes&);
    void drop_first_byte(std::size_t direction) { arrivals[first(direction)] = never; }
    bool expects_first_byte(std::size_t direction) const { return arrivals[first(direction)] != never; }
    void drop_last_bytes(std::size_t direction) { arrivals[last(direction)] = last_bytes_after[direction] = never; }
    /// Drops the arrival of the last byte of the current part. Keeps the arrival for the previous part.
    void drop_last_byte(std::size_t direction);
    void drop_end_of_sending(std::size_t direction) { arrivals[end_of_sending(direction)] = never; }
    bool expects_end_of_sending(std::size_t direction) const { return arrivals[end_of_sending(direction)] != never; }
    bool expects_last_byte(std::size_t direction) const { return arrivals[last(direction)] != never; }

    /// Returns whether the last byte that began still lacks its acknowledge.
    bool is_unacknowledged(std::size_t direction) const;
    /// Returns whether the receiver will certainly take a first byte that begins now, because it waits and is not still
    /// waiting for the previous part.
    bool is_sure_of_receiver(std::size_t direction) const {
        return directions[direction].receiver == Receiver::waits && !expects_last_byte(direction);
    }
    /// Returns a time up to which packets of this direction can be computed together. Until then the packets change
    /// only times and numbers of bytes.
    Time runs_before(std::size_t direction, const PacketTimes&) const;
    /// Returns the index of the earliest entry of `arrivals`.
    std::size_t first_arrival() const;

private:
    static constexpr std::size_t first(std::size_t direction) { return direction * arrivals_of_a_direction; }
    static constexpr std::size_t last(std::size_t direction) { return first(direction) + 1; }
    static constexpr std::size_t end_of_sending(std::size_t direction) { return first(direction) + 2; }
    bool is_first_byte_foreseen(std::size_t direction, const PacketTimes& times) const {
        return is_sure_of_receiver(direction) && times.overlaps() && !may_lose_packets;
    }
    Outcome begin_byte(std::size_t direction, const PacketTimes&, Fate);
    Outcome begin_acknowledge(std::size_t direction, const PacketTimes&, Fate);
    Outcome last_byte_arrives(std::size_t direction);
};

} // namespace placedpar::hardware
