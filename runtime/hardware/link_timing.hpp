#pragma once

#include "runtime/time.hpp"

#include <array>

namespace placedpar::hardware {

/// How long the bits of a link take. Published: a data packet is 11 bits (start, one, eight data bits, stop), an
/// acknowledge 2 (databook, 3rd ed. 1992, 1.4); with overlapped acknowledges one is sent 5 to 6 bit periods
/// after the start of the byte, and the next byte starts 5 to 6 after the acknowledge (D. Jeffery,
/// comp.sys.transputer, 13 March 1989).
///
/// Within those ranges, two values are fitted to measurements of whole links at 20 Mbit/s. In one direction a byte
/// takes 11.5 bit periods by the databook's table 8.1 (T805, 1740 Kbyte/s), 11.4 by K. Koontz (1.75 Mbyte/s,
/// comp.sys.transputer, January 1991), and 11.25 by the ping-pong of Poznan (2008). The latter measured 21.5 through
/// three switches, which leaves 11.0 without them. These figures differ by up to 5 %, and 11.2 is within 3 % of each.
/// In both directions at once a byte takes 17.0 bit periods (2350 Kbyte/s in sum): 11 and the restart. At 10 and 5
/// Mbit/s it takes fewer bit periods, so part of the restart is modelled as logic that does not slow down with the
/// link.
struct LinkTiming {
    static constexpr std::int64_t usual_speed = 20'000'000;
    std::int64_t bits_per_second = usual_speed;
    Time wire_delay{};                  ///< delay of wire and switches, one way
    bool overlapped_acknowledge = true; ///< T800, T805, T425; not T414

    static constexpr std::int64_t data_bits = 11;
    static constexpr std::int64_t acknowledge_bits = 2;
    /// Latencies in tenths of a bit period, and the part of the restart that does not depend on the speed.
    static constexpr std::int64_t acknowledge_tenths = 52, restart_tenths = 36;
    static constexpr Time restart_logic = std::chrono::nanoseconds{120};
    /// Delay of a metre of wire, as a transmission line.
    static constexpr Time metre_of_wire = std::chrono::nanoseconds{5};

    constexpr Time data() const { return duration_of(data_bits, bits_per_second); }
    constexpr Time acknowledge() const { return duration_of(acknowledge_bits, bits_per_second); }

    /// Returns the time from the start of a byte at the receiver to the start of its acknowledge, if a receiver waits
    /// and the wire is free: 5.2 bit periods; without overlap, counted from the end of the byte.
    constexpr Time acknowledge_latency() const {
        Time latency = duration_of(acknowledge_tenths, 10 * bits_per_second);
        return overlapped_acknowledge ? latency : data() + latency;
    }
    /// Returns the time from the start of the acknowledge at the sender to the start of the next byte: 6 bit periods at
    /// 20 Mbit/s; without overlap, counted from the end of the acknowledge.
    constexpr Time restart_latency() const {
        Time latency = duration_of(restart_tenths, 10 * bits_per_second) + restart_logic;
        return overlapped_acknowledge ? latency : acknowledge() + latency;
    }
};

/// The times of LinkTiming, worked out once, since links need them for each packet.
struct PacketTimes {
    struct Packet {
        Time carried;   ///< how long its wire carries it
        Time to_answer; ///< from its start to the request for its answer: the acknowledge of a byte, the byte after it
    };
    explicit constexpr PacketTimes(const LinkTiming& timing)
        : packets{Packet{timing.data(), later(timing.wire_delay, timing.acknowledge_latency())},
                  Packet{timing.acknowledge(), later(timing.wire_delay, timing.restart_latency())}},
          wire_delay(timing.wire_delay) {}

    const Packet& byte() const { return packets[0]; }
    const Packet& acknowledge() const { return packets[1]; }
    /// Returns the time from the start of a byte, or of an acknowledge, until the whole of it has arrived.
    Time arrival() const { return later(wire_delay, byte().carried); }
    Time acknowledge_arrival() const { return later(wire_delay, acknowledge().carried); }
    /// Whether a byte is noticed before the whole of it has arrived.
    bool overlaps() const { return byte().to_answer < arrival(); }

    std::array<Packet, 2> packets; ///< a byte, an acknowledge
    Time wire_delay;
};

} // namespace placedpar::hardware
