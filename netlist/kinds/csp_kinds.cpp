#include "netlist/kinds/csp_kinds.hpp"

#include "netlist/kinds/catalogue.hpp"
#include "netlist/kinds/description.hpp"
#include "netlist/kinds/environment.hpp"
#include "netlist/kinds/packet.hpp"
#include "runtime/executive.hpp"
#include "runtime/parallel.hpp"
#include "runtime/timer.hpp"

#include <fmt/format.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace placedpar {

namespace {

using description::packet_bytes;
using description::packet_count;
using description::packet_cycles;
using description::packet_words;
using description::packets_in;
using description::packets_out;

Packet first_packet(const ProcessEnvironment& environment) {
    return {0, static_cast<std::uint32_t>(environment.integer("bytes"))};
}

/// Simulates a computation for each packet. The parameters `cycles` and `words` of the process state the number of
/// processor cycles, and of accesses to memory outside of the chip.
class Work {
public:
    explicit Work(const ProcessEnvironment& environment)
        : cycles_{environment.integer("cycles")}, grain_{.words_outside = environment.integer("words")} {}
    void compute() const { placedpar::compute(cycles_, grain_); }

private:
    Cycles cycles_;
    CodeShape grain_;
};

// In textbooks these processes run for ever. Here each process ends after a stated number of packets, so that runs can
// be compared. If a process ends sooner than its neighbour, the neighbour waits, and the report of the run lists it. A
// ring deadlocks at once if none of its processes outputs first (examples/csp/deadlock).

/// Executes `count` times: inputs a packet, computes, and calls `hand_on` with the packet.
template <class HandOn>
void relay(ProcessEnvironment& environment, HandOn hand_on) {
    auto from = environment.input<Packet>("in");
    const Work work(environment);
    std::int64_t packets = environment.integer("count");
    for (std::int64_t i = 0; i < packets; ++i) {
        Packet packet = from.input();
        work.compute();
        hand_on(packet, i + 1 == packets);
    }
}

void produce(ProcessEnvironment& environment) {
    auto to = environment.output<Packet>("out");
    Packet packet = first_packet(environment);
    const Work work(environment);
    for (std::int64_t i = 0; i < environment.integer("count"); ++i) {
        work.compute();
        packet.number = i;
        to.output(packet);
    }
}

void identity(ProcessEnvironment& environment) {
    auto to = environment.output<Packet>("out");
    relay(environment, [&](const Packet& packet, bool) { to.output(packet); });
}

void prefix(ProcessEnvironment& environment) {
    auto to = environment.output<Packet>("out");
    to.output(first_packet(environment));
    relay(environment, [&](const Packet& packet, bool last) {
        if (!last)
            to.output(packet);
    });
}

void delta(ProcessEnvironment& environment) {
    auto to = environment.outputs<Packet>("out");
    relay(environment, [&](const Packet& packet, bool) {
        for (auto& each : to)
            each.output(packet);
    });
}

void par_delta(ProcessEnvironment& environment) {
    auto to = environment.outputs<Packet>("out");
    relay(environment,
          [&](const Packet& packet, bool) { par_for(to.size(), [&](std::size_t i) { to[i].output(packet); }); });
}

void successor(ProcessEnvironment& environment) {
    auto to = environment.output<Packet>("out");
    relay(environment, [&](const Packet& packet, bool) { to.output({packet.number + 1, packet.bytes}); });
}

void consume(ProcessEnvironment& environment) {
    Time began = now();
    std::int64_t packets = 0, received = 0, last_number = 0;
    relay(environment, [&](const Packet& packet, bool) {
        ++packets;
        received += packet.bytes;
        last_number = packet.number;
    });
    double milliseconds = in_milliseconds(now() - began);
    environment.measure("time", milliseconds, "ms");
    environment.measure("last_number", static_cast<double>(last_number));
    if (milliseconds > 0) {
        environment.measure("time_per_packet", milliseconds * 1000 / static_cast<double>(packets), "us");
        environment.measure("rate", static_cast<double>(received) / milliseconds, "Kbyte/s");
    }
}

/// Returns the Promela statements for relay(): `count` times, an input followed by the statements of `and_then`.
PromelaStatements relayed(std::function<std::string(const PromelaProcess&)> and_then) {
    return [and_then = std::move(and_then)](const PromelaProcess& self) {
        return promela_loop(self.integer("count"), self.channel("in") + " ? m;\n" + and_then(self));
    };
}

std::string nothing(const PromelaProcess&) { return ""; }

/// Returns statements in Promela that output the packet to all channels of the port `out`, in order.
std::string handed_on(const PromelaProcess& self) {
    std::string statements;
    for (const std::string& out : self.channels("out"))
        statements += out + " ! m;\n";
    return statements;
}

std::string handed_on_but_the_last(const PromelaProcess& self) {
    return fmt::format("if\n:: i < {} -> {} ! m\n:: else\nfi\n", self.integer("count"), self.channel("out"));
}

ProcessKind producer_kind() {
    return {.name = "csp.producer",
            .about = "Outputs numbered packets.",
            .ports = {packets_out()},
            .parameters = {packet_count(), packet_bytes(), packet_cycles(), packet_words()},
            .body = produce,
            .is_determinate = always,
            .promela = [](const PromelaProcess& self) { return promela_loop(self.integer("count"), handed_on(self)); }};
}

/// Returns a kind whose processes input packets and output them again, as `body` does.
ProcessKind relay_kind(std::string name, std::string about, std::function<void(ProcessEnvironment&)> body) {
    return {.name = std::move(name),
            .about = std::move(about),
            .ports = {packets_in(), packets_out()},
            .parameters = {packet_count(), packet_cycles(), packet_words()},
            .body = std::move(body),
            .is_determinate = always,
            .promela = relayed(handed_on)};
}

ProcessKind identity_kind() {
    return relay_kind("csp.identity", "Outputs each packet that it inputs: a buffer for one packet.", identity);
}

ProcessKind prefix_kind() {
    return {.name = "csp.prefix",
            .about = "Outputs a packet first, then each packet that it inputs; keeps the last packet.",
            .ports = {packets_in(), packets_out()},
            .parameters = {packet_count(), packet_bytes(), packet_cycles(), packet_words()},
            .body = prefix,
            .is_determinate = always,
            .promela = [](const PromelaProcess& self) {
                return self.channel("out") + " ! m;\n" + relayed(handed_on_but_the_last)(self);
            }};
}

/// Returns the kind, with a port `out` that is an array.
ProcessKind with_outputs(ProcessKind kind) {
    kind.ports.back() = packets_out("out", "outputs the packets; an array of one element or more");
    return kind;
}

ProcessKind delta_kind() {
    return with_outputs(
        relay_kind("csp.delta", "Outputs each input packet on all elements of its output array, in order.", delta));
}

/// This kind has no model in Promela, since its components would be separate processes there.
ProcessKind par_delta_kind() {
    ProcessKind kind = with_outputs(relay_kind("csp.par_delta",
                                               "Outputs each input packet on all elements of its output array at the "
                                               "same time, in a PAR. On channels placed on a bus this is a broadcast.",
                                               par_delta));
    kind.promela = {};
    return kind;
}

ProcessKind successor_kind() {
    return relay_kind("csp.successor", "Outputs each input packet with its number increased by one.", successor);
}

ProcessKind consumer_kind() {
    return {.name = "csp.consumer",
            .about = "Inputs packets and measures their rate.",
            .ports = {packets_in()},
            .parameters = {packet_count(), packet_cycles(), packet_words()},
            .measurements = {{"time", "ms", "time from the start of the run to the last packet"},
                             {"last_number", "", "the number of the last packet"},
                             {"time_per_packet", "us", "mean time for a packet"},
                             {"rate", "Kbyte/s", "rate of the packets' bytes; 1 Kbyte is 1000 bytes"}},
            .body = consume,
            .is_determinate = always,
            .promela = relayed(nothing)};
}

} // namespace

void add_csp_kinds(Catalogue& catalogue) {
    for (auto kind :
         {producer_kind(), identity_kind(), prefix_kind(), delta_kind(), par_delta_kind(), successor_kind(),
          consumer_kind(), sender_or_fail_kind(), receiver_or_fail_kind(), switch_logic_kind(), switch_setter_kind()})
        catalogue.add(std::move(kind));
}

} // namespace placedpar
