#include "netlist/csp_kinds.hpp"

#include "netlist/catalogue.hpp"
#include "netlist/environment.hpp"
#include "runtime/channel.hpp"
#include "runtime/executive.hpp"
#include "runtime/timer.hpp"

#include <memory>
#include <utility>
#include <vector>

namespace placedpar {

namespace {

/// A number in a message of stated length.
struct Packet {
    std::int64_t number = 0;
    std::uint32_t bytes = 4;
    WireForm wire_form() const { return WireForm(bytes); }
};

PortDescription port(std::string name, Direction direction, std::string about) {
    return {std::move(name), direction,
            false,           "packet",
            typeid(Packet),  [](std::string channel) { return std::make_unique<Channel<Packet>>(std::move(channel)); },
            std::move(about)};
}

PortDescription in() { return port("in", Direction::input, "packets come in"); }
PortDescription out(std::string name = "out") { return port(std::move(name), Direction::output, "packets go out"); }

ParameterDescription count() {
    return {"count",   ParameterType::integer,
            "packets", std::int64_t{1000},
            1,         1e12,
            {},        "packets that pass before it ends"};
}
ParameterDescription cycles() {
    return {"cycles", ParameterType::integer,
            "cycles", std::int64_t{0},
            0,        1e12,
            {},       "workload: computation for each packet"};
}
ParameterDescription bytes() {
    return {"bytes", ParameterType::integer, "bytes", std::int64_t{4}, 1, 1e9, {}, "length of a packet on the wire"};
}

/// `count` times: take a packet, compute, hand it on.
template <class HandOn>
void relay(ProcessEnvironment& environment, HandOn hand_on) {
    auto from = environment.input<Packet>("in");
    Cycles work{environment.integer("cycles")};
    std::int64_t packets = environment.integer("count");
    for (std::int64_t i = 0; i < packets; ++i) {
        Packet packet = from.input();
        compute(work);
        hand_on(packet, i + 1 == packets);
    }
}

Packet first_packet(const ProcessEnvironment& environment) {
    return {0, static_cast<std::uint32_t>(environment.integer("bytes"))};
}

void produce(ProcessEnvironment& environment) {
    auto to = environment.output<Packet>("out");
    Packet packet = first_packet(environment);
    Cycles work{environment.integer("cycles")};
    for (std::int64_t i = 0; i < environment.integer("count"); ++i) {
        compute(work);
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

void successor(ProcessEnvironment& environment) {
    auto to = environment.output<Packet>("out");
    relay(environment, [&](Packet packet, bool) {
        ++packet.number;
        to.output(packet);
    });
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

} // namespace

void add_csp_kinds(Catalogue& catalogue) {
    catalogue.add({"csp.producer", "Outputs numbered packets.", {out()}, {count(), bytes(), cycles()}, {}, produce});
    catalogue.add({"csp.identity",
                   "Outputs what it inputs: a buffer for one packet.",
                   {in(), out()},
                   {count(), cycles()},
                   {},
                   identity});
    catalogue.add({"csp.prefix",
                   "Outputs a packet first, then what it inputs; takes the last packet in and keeps it.",
                   {in(), out()},
                   {count(), bytes(), cycles()},
                   {},
                   prefix});
    catalogue.add({"csp.delta",
                   "Outputs what it inputs to each of its outputs, an array, in order.",
                   {in(), out()},
                   {count(), cycles()},
                   {},
                   delta});
    catalogue.add({"csp.successor",
                   "Outputs what it inputs with the number one higher.",
                   {in(), out()},
                   {count(), cycles()},
                   {},
                   successor});
    catalogue.add({"csp.consumer",
                   "Takes packets in and measures how fast they come.",
                   {in()},
                   {count(), cycles()},
                   {{"time", "ms", "from its start to the last packet"},
                    {"last_number", "", "the number of the last packet"},
                    {"time_per_packet", "us", "mean"},
                    {"rate", "Kbyte/s", "of the packets' bytes; 1000 bytes a Kbyte"}},
                   consume});
}

} // namespace placedpar
