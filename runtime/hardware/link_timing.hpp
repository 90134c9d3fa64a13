#pragma once

#include "runtime/time.hpp"

#include <algorithm>

namespace placedpar::hardware {

/// How long the bits of a link take. Published: a data packet is 11 bits (start, one, eight data bits, stop), an
/// acknowledge 2 (databook, 3rd ed. 1992, 1.4); with overlapped acknowledges one is sent 5 to 6 bit periods
/// after the start of the byte, and the next byte starts 5 to 6 after the acknowledge (D. Jeffery,
/// comp.sys.transputer, 13 March 1989). Within those ranges the values below give the databook's table 8.1
/// (T805): 1740 and 2350 Kbyte/s at 20 Mbit/s, and its figures at 10 and 5 Mbit/s, for which part of the
/// restart is taken as logic that does not slow down with the link.
struct LinkTiming {
    std::int64_t bits_per_second = 20'000'000;
    Time wire_delay{};                  ///< one way, of wire and switches
    bool overlapped_acknowledge = true; ///< T800, T805, T425; not T414

    static constexpr std::int64_t data_bits = 11;
    static constexpr std::int64_t acknowledge_bits = 2;

    constexpr Time data() const { return duration_of(data_bits, bits_per_second); }
    constexpr Time acknowledge() const { return duration_of(acknowledge_bits, bits_per_second); }

    /// From the start of a byte at the receiver to the start of its acknowledge, if a process takes the byte
    /// and the wire is free: 5.5 bit periods; without overlap, counted from the end of the byte.
    constexpr Time acknowledge_latency() const {
        Time latency = duration_of(55, 10 * bits_per_second);
        return overlapped_acknowledge ? latency : data() + latency;
    }
    /// From the start of the acknowledge at the sender to the start of the next byte: 6 bit periods at
    /// 20 Mbit/s; without overlap, counted from the end of the acknowledge.
    constexpr Time restart_latency() const {
        Time latency = duration_of(32, 10 * bits_per_second) + std::chrono::nanoseconds{140};
        return overlapped_acknowledge ? latency : acknowledge() + latency;
    }
    /// From the start of a byte to the start of the next when the other direction is quiet and the receiver ready.
    constexpr Time byte_period() const {
        return std::max(data(), 2 * wire_delay + acknowledge_latency() + restart_latency());
    }
};

} // namespace placedpar::hardware
