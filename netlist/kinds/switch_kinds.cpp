// This file defines two kinds for a switch that is set during the run: the logic of the switch, and a process that sets
// the switch.

#include "netlist/kinds/csp_kinds.hpp"
#include "netlist/kinds/description.hpp"
#include "netlist/kinds/device_kind.hpp"
#include "netlist/kinds/environment.hpp"
#include "netlist/kinds/packet.hpp"
#include "netlist/network/names.hpp"
#include "netlist/network/network.hpp"
#include "runtime/executive.hpp"
#include "runtime/hardware/crossbar.hpp"
#include "runtime/timer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace placedpar {

namespace {

using description::input;
using description::integer;
using description::optional;
using description::output;
using description::packet_bytes;
using description::packet_count;
using description::packet_cycles;
using description::packets_in;
using description::packets_out;
using hardware::SwitchAnswer;
using hardware::SwitchCommand;

void obey_for_ever(ProcessEnvironment& environment) {
    auto commands = environment.input<SwitchCommand>("commands");
    hardware::Crossbar& crossbar = hardware::Crossbar::here();
    for (;;)
        if (auto answer = crossbar.obey(commands.input()); answer && environment.connected("answers"))
            environment.output<SwitchAnswer>("answers").output(*answer);
}

std::vector<Complaint> check_place_of_logic(const Network& network, std::size_t process) {
    const ProcessInstance& self = network.processes[process];
    if (network.nodes[self.node].kind->logic != self.kind)
        return {{process, "",
                 fmt::format("the process \"{}\" is the logic of a switch, but is placed on another device", self.name),
                 "place it on a C004, whose link config leads to the processor that sets it"}};
    for (std::size_t i = 0; i < process; ++i)
        if (network.processes[i].node == self.node)
            return {
                {process, "",
                 fmt::format("two processes are placed on the switch \"{}\" as its logic, but a switch has only one",
                             network.nodes[self.node].name),
                 ""}};
    return {};
}

/// Sends commands to a switch: connects one link of the switch with some of the other links, one after another.
class Setter {
public:
    explicit Setter(ProcessEnvironment& environment)
        : commands_(environment.output<SwitchCommand>("commands")), link_(number(environment, "link")),
          first_(number(environment, "first")) {
        if (environment.connected("answers"))
            answers_ = environment.input<SwitchAnswer>("answers");
    }

    void connect(std::size_t partner) {
        commands_.output({SwitchCommand::Kind::connect_links, link_, link_of(partner)});
        commands_.output({SwitchCommand::Kind::ready});
        if (answers_)
            enquire(partner);
    }

    /// Disconnects the present partner. Otherwise bytes for the next partner would reach this partner, too.
    void disconnect(std::size_t partner) {
        commands_.output({SwitchCommand::Kind::disconnect_links, link_, link_of(partner)});
    }

    std::int64_t wrong_answers() const { return wrong_answers_; }

private:
    static std::uint8_t number(const ProcessEnvironment& environment, const char* parameter) {
        return static_cast<std::uint8_t>(environment.integer(parameter));
    }
    std::uint8_t link_of(std::size_t partner) const { return static_cast<std::uint8_t>(first_ + partner); }

    void enquire(std::size_t partner) {
        commands_.output({SwitchCommand::Kind::enquire, link_of(partner)});
        wrong_answers_ += answers_.input().byte != (link_ | SwitchAnswer::connected);
    }

    Output<SwitchCommand> commands_;
    Input<SwitchAnswer> answers_; ///< no channel if the port `answers` is not connected
    std::uint8_t link_, first_;
    std::int64_t wrong_answers_ = 0;
};

template <class Body>
Time time_of(Body body) {
    Time began = now();
    body();
    return now() - began;
}

void visit_partners(ProcessEnvironment& environment) {
    auto to = environment.outputs<Packet>("out");
    auto from = environment.inputs<Packet>("in");
    Setter setter(environment);
    Packet packet{0, static_cast<std::uint32_t>(environment.integer("bytes"))};
    Cycles work{environment.integer("cycles")};
    Time began = now(), setting{};
    for (std::int64_t i = 0; i < environment.integer("count"); ++i)
        for (std::size_t partner = 0; partner < to.size(); ++partner) {
            compute(work);
            setting += time_of([&] { setter.connect(partner); });
            to[partner].output({packet.number++, packet.bytes});
            if (!from.empty())
                from[partner].input();
            setting += time_of([&] { setter.disconnect(partner); });
        }
    double visits = static_cast<double>(packet.number);
    environment.measure("time", in_milliseconds(now() - began), "ms");
    environment.measure("time_per_visit", in_milliseconds(now() - began) * 1000 / visits, "us");
    environment.measure("setting_per_visit", in_milliseconds(setting) * 1000 / visits, "us");
    environment.measure("wrong_answers", static_cast<double>(setter.wrong_answers()));
}

std::size_t count_ports(const ProcessInstance& process, std::string_view name) {
    return static_cast<std::size_t>(
        std::ranges::count_if(process.ports, [&](const PortBinding& each) { return base_name(each.port) == name; }));
}

std::vector<Complaint> check_partners(const Network& network, std::size_t process) {
    const ProcessInstance& self = network.processes[process];
    auto partners = count_ports(self, "out"), answers = count_ports(self, "in");
    if (answers != 0 && answers != partners)
        return {{process, "in",
                 fmt::format("\"{}\" outputs to {} partners but inputs from {}", self.name, partners, answers),
                 "connect inputs from all partners or from none"}};
    auto last = std::get<std::int64_t>(self.parameters.at("first")) + static_cast<std::int64_t>(partners) - 1;
    if (last >= hardware::Crossbar::links)
        return {{process, "first",
                 fmt::format("the last of {} partners would be at link {} of the switch", partners, last),
                 fmt::format("a C004 has the links 0 to {}", hardware::Crossbar::links - 1)}};
    return {};
}

ParameterDescription link_of_switch(const char* name, std::int64_t by_default, const char* about) {
    return integer(name, {.by_default = by_default, .least = 0, .most = hardware::Crossbar::links - 1}, about);
}

} // namespace

ProcessKind switch_logic_kind() {
    return {.name = "csp.switch_logic",
            .about = "The logic of a C004: obeys the commands from its configuration link, connects and disconnects "
                     "links, and answers. It must be placed on the switch, is a part of the machine, and never ends.",
            .ports = {input<SwitchCommand>("commands", "c004 command", "1 to 3 bytes"),
                      optional(output<SwitchAnswer>("answers", "c004 answer", "one byte, the answer to command 2"))},
            .body = obey_for_ever,
            .check = check_place_of_logic};
}

ProcessKind switch_setter_kind() {
    return {.name = "csp.switching_producer",
            .about = "Visits its partners in turn over a switch: connects to the partner, outputs a packet, inputs a "
                     "packet if its inputs are connected, and disconnects.",
            .ports = {output<SwitchCommand>("commands", "c004 command", "commands to the switch"),
                      optional(input<SwitchAnswer>("answers", "c004 answer",
                                                   "answers of the switch; if connected, the process asks the switch "
                                                   "for its state after each connection")),
                      packets_out("out", "an array with one output to each partner"),
                      optional(packets_in("in", "an array with one input from each partner"))},
            .parameters = {packet_count("number of rounds with a packet to each partner"), packet_bytes(),
                           packet_cycles(), link_of_switch("link", 0, "link of the switch that leads to its processor"),
                           link_of_switch("first", 1,
                                          "link of the switch that leads to partner 0; the following links lead to "
                                          "the other partners")},
            .measurements = {{"time", "ms", "time of all rounds"},
                             {"time_per_visit", "us", "mean time of a visit"},
                             {"setting_per_visit", "us", "mean time that the switch's commands take in a visit"},
                             {"wrong_answers", "", "wrong answers of the switch"}},
            .body = visit_partners,
            .check = check_partners};
}

} // namespace placedpar
