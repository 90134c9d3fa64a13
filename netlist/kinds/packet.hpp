#pragma once

#include "netlist/kinds/description.hpp"
#include "runtime/byte_form.hpp"
#include "runtime/protocol.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace placedpar {

/// Holds a message of the processes in csp_kinds.hpp: a number, and the length of the message on a link.
struct Packet {
    std::int64_t number = 0;
    std::uint32_t bytes = 4;
    WireForm wire_form() const { return WireForm(bytes); }
    bool operator==(const Packet&) const = default;
};

/// Defines the bytes of a packet on a link, for messages between a process in C++ and a transputer's machine code. The
/// bytes are the number, as an INT of four bytes, followed by zeros up to the length. If the machine code outputs an
/// INT, the process inputs this INT as a packet of four bytes.
template <>
struct ByteForm<Packet> {
    using SameAs = std::int32_t;

    static void write(const Packet& packet, MessageBytes& to) {
        const std::size_t begin = to.size();
        ByteForm<std::int32_t>::write(static_cast<std::int32_t>(packet.number), to);
        to.resize(begin + packet.bytes);
    }
    static std::uint32_t next_part(std::span<const std::uint8_t> so_far) {
        return ByteForm<std::int32_t>::next_part(so_far);
    }
    static Packet read(std::span<const std::uint8_t> bytes) { return {ByteForm<std::int32_t>::read(bytes)}; }
};

namespace description {

inline PortDescription packets_in(std::string name = "in", std::string about = "inputs the packets") {
    return input<Packet>(std::move(name), "packet", std::move(about));
}
inline PortDescription packets_out(std::string name = "out", std::string about = "outputs the packets") {
    return output<Packet>(std::move(name), "packet", std::move(about));
}

inline ParameterDescription packet_count(std::string about = "number of packets until the process ends") {
    return integer("count", {.unit = "packets", .by_default = 1000, .least = 1, .most = 1e12}, std::move(about));
}
inline ParameterDescription packet_bytes() {
    return integer("bytes", {.unit = "bytes", .by_default = 4, .least = 1, .most = 1e9},
                   "length of a packet on the wire");
}
inline ParameterDescription packet_cycles(std::string about = "workload: computation for each packet") {
    return integer("cycles", {.unit = "cycles", .by_default = 0, .least = 0, .most = 1e12}, std::move(about));
}
/// Returns the parameter `words`: the value of CodeShape::words_outside, the number of a computation's accesses to
/// external memory.
inline ParameterDescription packet_words() {
    return integer("words", {.unit = "words", .by_default = 0, .least = 0, .most = 1e9},
                   "workload: accesses to external memory for each packet; an access takes memorycycles, and replaces "
                   "one of the `cycles`");
}

} // namespace description

} // namespace placedpar
