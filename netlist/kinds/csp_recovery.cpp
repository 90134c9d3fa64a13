// These processes use time-outs, so that they survive a link that fails.

#include "netlist/kinds/csp_kinds.hpp"
#include "netlist/kinds/description.hpp"
#include "netlist/kinds/environment.hpp"
#include "netlist/kinds/packet.hpp"
#include "netlist/network/network.hpp"
#include "runtime/executive.hpp"
#include "runtime/recovery.hpp"
#include "runtime/timer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

namespace placedpar {

namespace {

using description::packet_bytes;
using description::packet_count;
using description::packet_cycles;
using description::packets_in;
using description::packets_out;

Time timeout_of(const ProcessEnvironment& environment) {
    return std::chrono::microseconds{environment.integer("timeout")};
}

/// Outputs packets with a time-out. After a time-out, gives up the packet, and resets the channel before the next
/// packet.
void produce_or_fail(ProcessEnvironment& environment) {
    auto to = environment.output<Packet>("out");
    Packet packet{0, static_cast<std::uint32_t>(environment.integer("bytes"))};
    Cycles work{environment.integer("cycles")};
    std::int64_t given_up = 0;
    for (std::int64_t i = 0; i < environment.integer("count"); ++i) {
        compute(work);
        packet.number = i;
        if (output_or_fail(to, packet, later(now(), timeout_of(environment))))
            continue;
        ++given_up;
        reset(to);
    }
    environment.measure("given_up", static_cast<double>(given_up), "packets");
}

/// Inputs packets with a time-out. Ends with the last packet, or after `patience` time-outs in a row.
void consume_or_fail(ProcessEnvironment& environment) {
    auto from = environment.input<Packet>("in");
    Cycles work{environment.integer("cycles")};
    std::int64_t last = environment.integer("count") - 1, received = 0, resets = 0, in_vain = 0;
    std::uint64_t bytes_of_pieces = 0;
    Packet packet;
    while (packet.number < last || received == 0) {
        if (input_or_fail(from, packet, later(now(), timeout_of(environment)))) {
            ++received;
            in_vain = 0;
            compute(work);
            continue;
        }
        ++resets;
        bytes_of_pieces += reset(from);
        if (++in_vain == environment.integer("patience"))
            break;
    }
    environment.measure("received", static_cast<double>(received), "packets");
    environment.measure("lost", static_cast<double>(last + 1 - received), "packets");
    environment.measure("resets", static_cast<double>(resets));
    environment.measure("bytes_of_pieces", static_cast<double>(bytes_of_pieces), "bytes");
}

/// Returns the reason why a message on the channel cannot be given up; "" if it can be given up.
std::string why_not_given_up(const Network& network, const NetworkChannel& channel) {
    const ChannelPlacement& at = channel.placement;
    if (at.in_packets)
        return "is carried in packets, which cannot be taken back";
    if (at.broadcast_on != nowhere)
        return "is broadcast with other channels";
    bool in_memory = std::ranges::any_of(at.route, [&](const RouteHop& hop) {
        const auto& over_bus = network.connections[hop.connection].over_bus;
        return over_bus && over_bus->wire == nowhere;
    });
    return in_memory ? "leads through the memory of a bus master" : "";
}

std::vector<Complaint> require_can_give_up(const Network& network, std::size_t process) {
    std::vector<Complaint> complaints;
    for (const PortBinding& port : network.processes[process].ports) {
        const NetworkChannel& channel = network.channels[port.channel];
        if (std::string reason = why_not_given_up(network, channel); !reason.empty())
            complaints.push_back(
                {.process = process,
                 .about = port.port,
                 .message =
                     fmt::format("the channel \"{}\" {}, so its process cannot give up a packet", channel.name, reason),
                 .hint = "a time-out needs a channel between processes on one processor, or a channel placed alone on "
                         "a link"});
    }
    return complaints;
}

ParameterDescription packet_timeout(const char* about) {
    return description::integer("timeout", {.unit = "us", .by_default = 1000, .least = 1, .most = 1e9}, about);
}

} // namespace

ProcessKind sender_or_fail_kind() {
    return {.name = "csp.sender_or_fail",
            .about = "Outputs numbered packets, each with a time-out; gives up a packet that is not sent before "
                     "the time-out.",
            .ports = {packets_out()},
            .parameters = {packet_count(), packet_bytes(), packet_cycles(),
                           packet_timeout("time after which the process gives up a packet")},
            .measurements = {{"given_up", "packets", "packets whose transfer was not confirmed before the time-out"}},
            .body = produce_or_fail,
            .check = require_can_give_up};
}

ProcessKind receiver_or_fail_kind() {
    return {.name = "csp.receiver_or_fail",
            .about = "Inputs packets, each with a time-out; resets its channel if no packet arrives before the "
                     "time-out.",
            .ports = {packets_in()},
            .parameters = {packet_count("number of packets until the process ends"), packet_cycles(),
                           packet_timeout("time after which the process resets its channel"),
                           description::integer("patience", {.by_default = 10, .least = 1, .most = 1e9},
                                                "number of consecutive time-outs after which the process ends")},
            .measurements = {{"received", "packets", ""},
                             {"lost", "packets", "packets that did not arrive"},
                             {"resets", "", "resets of its channel"},
                             {"bytes_of_pieces", "bytes", "bytes of incomplete packets"}},
            .body = consume_or_fail,
            .check = require_can_give_up};
}

} // namespace placedpar
