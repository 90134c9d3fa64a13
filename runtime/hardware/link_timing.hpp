#pragma once

#include "runtime/time.hpp"

#include <array>

namespace placedpar::hardware {

/// The times of a link's bits. Published: a data packet has 11 bits (start, one, eight data bits, stop), an acknowledge
/// has 2 (databook, 3rd ed. 1992, 1.4). With overlapped acknowledges, an acknowledge is sent 5 to 6 bit periods after
/// the start of the byte, and the next byte starts 5 to 6 bit periods after the acknowledge (D. Jeffery,
/// comp.sys.transputer, 13 March 1989).
///
/// Within these ranges, the two latencies are fitted to measurements at 20 Mbit/s. If only one direction is used, a
/// byte takes 11.5 bit periods by the databook's table 8.1 (T805, 1740 Kbyte/s), 11.4 by K. Koontz (1.75 Mbyte/s,
/// comp.sys.transputer, January 1991), and 11.25 by a ping-pong program (sarevok/pr, Poznan 2008). The same program
/// measured 21.5 bit periods through three switches, that is, 11.0 without their delay. In this simulation a byte takes
/// 11.2 bit periods, within 3 % of each figure. If both directions are used, a byte takes 17.0 bit periods (2350
/// Kbyte/s in sum). At 10 and 5 Mbit/s a byte takes fewer bit periods. Therefore a part of the second latency is a
/// fixed time (`restart_logic`).
struct LinkTiming {
    static constexpr std::int64_t usual_speed = 20'000'000;
    std::int64_t bits_per_second = usual_speed;
    Time wire_delay{};                  ///< delay of the wire and of switches, in one direction
    bool overlapped_acknowledge = true; ///< true for T800, T805, T425; false for T414

    static constexpr std::int64_t data_bits = 11;
    static constexpr std::int64_t acknowledge_bits = 2;
    /// The latencies in tenths of a bit period: from a byte to its acknowledge, and from an acknowledge to the next
    /// byte (`restart`). `restart_logic`: the part of the restart that does not depend on the speed.
    static constexpr std::int64_t acknowledge_tenths = 52, restart_tenths = 36;
    static constexpr Time restart_logic = std::chrono::nanoseconds{120};
    /// The delay of one metre of wire, as a transmission line.
    static constexpr Time metre_of_wire = std::chrono::nanoseconds{5};

    constexpr Time data() const { return duration_of(data_bits, bits_per_second); }
    constexpr Time acknowledge() const { return duration_of(acknowledge_bits, bits_per_second); }

    /// Returns the time from the start of a byte at the receiver to the start of its acknowledge, if a receiver waits
    /// and the wire is free. With overlapped acknowledges it is 5.2 bit periods. Otherwise the acknowledge starts 5.2
    /// bit periods after the end of the byte.
    constexpr Time acknowledge_latency() const {
        Time latency = duration_of(acknowledge_tenths, 10 * bits_per_second);
        return overlapped_acknowledge ? latency : data() + latency;
    }
    /// Returns the time from the start of the acknowledge at the sender to the start of the next byte. At 20 Mbit/s
    /// with overlapped acknowledges it is 6 bit periods. Otherwise the byte starts 6 bit periods after the end of the
    /// acknowledge.
    constexpr Time restart_latency() const {
        Time latency = duration_of(restart_tenths, 10 * bits_per_second) + restart_logic;
        return overlapped_acknowledge ? latency : acknowledge() + latency;
    }
};

/// The times of LinkTiming, computed once, because links need them for each packet. A packet is a byte or an
/// acknowledge.
struct PacketTimes {
    struct Packet {
        Time carried;   ///< time for which the wire carries the packet
        Time to_answer; ///< time from the start of the packet to the request for its answer: the acknowledge after a
                        ///< byte, the next byte after an acknowledge
    };
    explicit constexpr PacketTimes(const LinkTiming& timing)
        : packets{Packet{timing.data(), later(timing.wire_delay, timing.acknowledge_latency())},
                  Packet{timing.acknowledge(), later(timing.wire_delay, timing.restart_latency())}},
          wire_delay(timing.wire_delay) {}

    const Packet& byte() const { return packets[0]; }
    const Packet& acknowledge() const { return packets[1]; }
    /// Return the time from the start of a byte (of an acknowledge) until the whole packet has arrived.
    Time arrival() const { return later(wire_delay, byte().carried); }
    Time acknowledge_arrival() const { return later(wire_delay, acknowledge().carried); }
    /// Returns whether an acknowledge begins before the whole byte has arrived.
    bool overlaps() const { return byte().to_answer < arrival(); }

    std::array<Packet, 2> packets; ///< a byte, an acknowledge
    Time wire_delay;
};

} // namespace placedpar::hardware
