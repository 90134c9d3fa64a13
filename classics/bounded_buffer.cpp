// A bounded buffer (Hoare, Communicating Sequential Processes, CACM 21, 1978, section 5.1). As in Hoare's paper and in
// occam, an output cannot be a guard. So the buffer, csp.buffer, outputs a packet only after a request. The process
// csp.customer, between the buffer and a consumer, sends the requests.

#include "classics/kinds.hpp"

#include "netlist/kinds/environment.hpp"
#include "netlist/kinds/packet.hpp"
#include "runtime/alternation.hpp"
#include "runtime/executive.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <deque>

namespace placedpar {

namespace {

void hold(ProcessEnvironment& environment) {
    auto in = environment.input<Packet>("in"), request = environment.input<Packet>("request");
    auto out = environment.output<Packet>("out");
    std::int64_t to_come = environment.integer("count"), to_go = to_come;
    auto capacity = static_cast<std::size_t>(environment.integer("capacity"));
    std::deque<Packet> held;
    std::size_t most = 0;
    while (to_go > 0)
        alt(when(held.size() < capacity && to_come > 0, on(in,
                                                           [&](const Packet& packet) {
                                                               held.push_back(packet);
                                                               most = std::max(most, held.size());
                                                               --to_come;
                                                           })),
            when(!held.empty(), on(request, [&](const Packet&) {
                out.output(held.front());
                held.pop_front();
                --to_go;
            })));
    environment.measure("most_held", static_cast<double>(most), "packets");
}

void ask_and_consume(ProcessEnvironment& environment) {
    auto request = environment.output<Packet>("request"), out = environment.output<Packet>("out");
    auto in = environment.input<Packet>("in");
    for (std::int64_t i = 0; i < environment.integer("count"); ++i) {
        request.output({i, 1});
        out.output(in.input());
    }
}

std::string holding_in_promela(const PromelaProcess& self) {
    std::string take = self.channel_if(
        fmt::format("held < {} && come < {}", self.integer("capacity"), self.integer("count")), self.channel("in"));
    std::string give = self.channel_if("held > 0", self.channel("request"));
    return fmt::format("int held, come, gone;\ndo\n:: gone < {} ->\nif\n:: {} ? m -> held++; come++\n"
                       ":: {} ? m -> {} ! m; held--; gone++\nfi\n:: else -> break\nod\n",
                       self.integer("count"), take, give, self.channel("out"));
}

std::string asking_in_promela(const PromelaProcess& self) {
    return promela_loop(self.integer("count"), fmt::format("{} ! m;\n{} ? m;\n{} ! m;\n", self.channel("request"),
                                                           self.channel("in"), self.channel("out")));
}

ProcessKind buffer() {
    using namespace description;
    return {.name = "csp.buffer",
            .about =
                "Holds packets, first in, first out, up to its capacity. A csp.customer asks for them, at `request`.",
            .ports = {packets_in(), packets_in("request", "asks for the next packet"), packets_out()},
            .parameters = {packet_count(),
                           integer("capacity", {.unit = "packets", .by_default = 10, .least = 1, .most = 1e9},
                                   "greatest number of packets in the buffer")},
            .measurements = {{"most_held", "packets", "at once"}},
            .body = hold,
            .promela = holding_in_promela};
}

ProcessKind customer() {
    using namespace description;
    return {.name = "csp.customer",
            .about = "Asks a csp.buffer for packets and outputs them: it stands between the buffer and a consumer.",
            .ports = {packets_out("request", "asks for the next packet"), packets_in(), packets_out()},
            .parameters = {packet_count()},
            .body = ask_and_consume,
            .promela = asking_in_promela};
}

} // namespace

std::vector<ProcessKind> bounded_buffer_kinds() { return {buffer(), customer()}; }

} // namespace placedpar
