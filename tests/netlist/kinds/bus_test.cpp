// Tests bus attachments in the netlist and in a run.

#include "netlist/kinds/csp_kinds.hpp"
#include "netlist/kinds/description.hpp"
#include "netlist/kinds/packet.hpp"
#include "netlist/machine.hpp"
#include "netlist/print/print.hpp"
#include "netlist/read.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

using namespace placedpar;

namespace {

constexpr const char* machine_on_bus =
    R"(/* A workstation, two bus masters and a module with two adapters on a VMEbus, in every way that the language has. */
VME (arbiter = "RRS", cycle = 250, timeout = 50000) vme;
workstation (clock = 25M) sun;
busmaster a;
BBKV2 (conversion = 8) b;
C012 adapter[2];
C011 (master = "a") own;
C004 sw;
T800 (memory = 1M) t[3];
connection to_a;
to_a (level = 1, release = "ROR");

connect sun.bus[0] to vme.slot[1];
connect a.bus[0] to vme.slot[2] by to_a;
connect vme.slot[3] to b.bus[0];
rep i = 0 for 2
    connect adapter[i].bus[0] to vme.slot[4];
connect own.bus[0] to vme.slot[5];
connect adapter[0].link[0] to sw.link[0];
connect sw.link[0] to sw.link[9];
connect sw.link[9] to t[0].link[3];
connect t[1].link[0] to adapter[1].link[0];
connect own.link[0] to t[2].link[0];
connect t[0].link[0] to t[1].link[1];

process (interface (output out)) source[5];
process (interface (input in)) sink[5];
use "csp.producer" for source;
use "csp.consumer" for sink;
rep i = 0 for 5 {
    source[i] (count = 5, bytes = 300);
    sink[i] (count = 5);
    connect source[i].out to sink[i].in;
}
place source[0] on sun;   /* by an adapter and a switch */
place sink[0] on t[0];
place source[1] on t[1];  /* back by the other */
place sink[1] on sun;
place source[2] on sun;   /* into dual-ported memory */
place sink[2] on a;
place source[3] on a;     /* from one bus master to the other */
place sink[3] on b;
place source[4] on t[2];  /* to the bus master that uses the adapter, and over the bus to the workstation */
place sink[4] on sun;
)";

const Catalogue& csp_catalogue() {
    static const Catalogue known = [] {
        Catalogue all;
        add_csp_kinds(all);
        return all;
    }();
    return known;
}

Network network_with_bus(const std::string& text) {
    ReadResult result = read_netlist_text(text, csp_catalogue(), {});
    INFO(render(result));
    REQUIRE(result.network);
    return *result.network;
}

const BusMasterUse& use_by(const RunReport& report, const std::string& name) {
    const auto& masters = report.buses.at(0).masters;
    auto found = std::ranges::find(masters, name, &BusMasterUse::name);
    REQUIRE(found != masters.end());
    return *found;
}

} // namespace

TEST_CASE("placement alone leads channels over buses, adapters and bus masters") {
    Network network = network_with_bus(machine_on_bus);
    auto hops = [&](std::size_t channel) { return network.channels[channel].placement.route.size(); };
    CHECK(hops(0) == 1);
    CHECK(hops(1) == 1);
    CHECK(hops(2) == 1);
    CHECK(hops(3) == 1);
    CHECK(hops(4) == 2);
    RunReport report = Machine(network, csp_catalogue(), 1).run();
    CHECK(report.result.ending == Ending::completed);
    for (int i = 0; i < 5; ++i)
        CHECK(report.measured("sink[" + std::to_string(i) + "]", "last_number") == 4);
    CHECK(use_by(report, "sun").bytes >= 2 * 2 * 5 * 300); // status and data accesses for the bytes of two channels
    CHECK(use_by(report, "a").bytes >= 2 * 5 * 300);
    CHECK(use_by(report, "a").words >= 5 * 75);
    CHECK(use_by(report, "a").level == 1);
    CHECK(use_by(report, "b").words == 0); // b only receives
    CHECK(report.buses.at(0).busy > Time{0});
}

TEST_CASE("the printed form of a network with a bus loads as the same network") {
    Network network = network_with_bus(machine_on_bus);
    std::string printed = print_cfs(network);
    Network again = network_with_bus(printed);
    CHECK(canonical_form(again) == canonical_form(network));
    CHECK(print_cfs(again) == printed);
    CHECK(printed.find("connect a.bus[0] to vme.slot[2] by to_a;") != std::string::npos);
    CHECK(printed.find("place source[4].out on t[2].link[0];\nplace source[4].out on a.bus[0];\n") !=
          std::string::npos);
    CHECK(print_json(network).find("\"over_bus\"") != std::string::npos);
    CHECK(print_dot(network).find("taillabel=\"4\", headlabel=\"\"") != std::string::npos);
}

TEST_CASE("a route over a bus is stated by an adapter's link or a master's place on the bus") {
    const std::string machine = R"(VME vme; workstation (clock = 25M) sun; busmaster bbk; C012 adapter[3]; T800 t[3];
        connect sun.bus[0] to vme.slot[1];
        connect bbk.bus[0] to vme.slot[2];
        connection cable[3];
        rep i = 0 for 2 {
            connect adapter[i].bus[0] to vme.slot[3];
            connect adapter[i].link[0] to t[i].link[0] by cable[i];
            connect t[i].link[2] to t[i + 1].link[3];
        }
        connect adapter[2].bus[0] to vme.slot[3];
        connect adapter[2].link[0] to bbk.link[0] by cable[2];
        process (interface (output out)) p; process (interface (input in)) c;
        use "csp.producer" for p; use "csp.consumer" for c; p (count = 3, bytes = 40); c (count = 3);
        connection channel;
        connect p.out to c.in by channel; place p on sun; )";
    struct Told {
        const char *places, *printed;
        std::size_t hops;
    };
    for (const Told& each : {
             Told{"place c on t[1];", "place c.in on t[1].link[0];", 1},
             Told{"place c on t[1]; place p.out on sun.bus[0];", "place c.in on t[1].link[0];", 1},
             Told{"place c on t[1]; place p.out on adapter[1].link[0];", "place c.in on t[1].link[0];", 1},
             Told{"place c on t[1]; place p.out on adapter[0].link[0];",
                  "place p.out on adapter[0].link[0];\nplace p.out on t[0].link[2];", 2},
             Told{"place c on t[1]; place channel on cable[0];",
                  "place p.out on adapter[0].link[0];\nplace p.out on t[0].link[2];", 2},
             Told{"place c on t[2]; place p.out on adapter[0].link[0];",
                  "place p.out on adapter[0].link[0];\nplace p.out on t[0].link[2];\nplace p.out on t[1].link[2];", 3},
             Told{"place c on t[2]; place p.out on sun.bus[0]; place p.out on t[0].link[2];",
                  "place p.out on adapter[0].link[0];\nplace p.out on t[0].link[2];\nplace p.out on t[1].link[2];", 3},
             Told{"place c on bbk;", "place c.in on bbk.link[0];", 1}, // the bus attachment with the lower number
             Told{"place c on bbk; place p.out on sun.bus[0];", "place p.out on sun.bus[0];", 1},
             Told{"place c on bbk; place c.in on bbk.bus[0];", "place p.out on sun.bus[0];", 1},
         }) {
        CAPTURE(each.places);
        Network network = network_with_bus(machine + each.places);
        CHECK(network.channels[0].placement.route.size() == each.hops);
        std::string printed = print_cfs(network);
        CHECK(printed.find(std::string("mapping */\nplace p on sun;\nplace c on ") +
                           network.nodes[network.processes[1].node].name + ";\n" + each.printed + "\n") !=
              std::string::npos);
        Network again = network_with_bus(printed);
        CHECK(again.hash == network.hash);
        CHECK(again.channels[0].placement == network.channels[0].placement);
        RunReport report = Machine(network, csp_catalogue(), 1).run();
        CHECK(report.measured("c", "last_number") == 2);
    }
}

TEST_CASE("a host sets a switch through a link adapter") {
    Catalogue kinds = csp_catalogue();
    kinds.add({.name = "test.agent",
               .about = "Passes on what comes, and the answer back.",
               .ports = {description::packets_in("in"), description::packets_out("out"),
                         description::packets_in("answers_in"), description::packets_out("answers_out")},
               .parameters = {description::packet_count()},
               .body = [](ProcessEnvironment& environment) {
                   auto in = environment.inputs<Packet>("in"), back = environment.inputs<Packet>("answers_in");
                   auto out = environment.outputs<Packet>("out"), answers = environment.outputs<Packet>("answers_out");
                   for (std::int64_t round = 0; round < environment.integer("count"); ++round)
                       for (std::size_t i = 0; i < in.size(); ++i) {
                           out[i].output(in[i].input());
                           answers[i].output(back[i].input());
                       }
               }});
    const std::string text = R"(VME vme; workstation (clock = 25M) sun; C012 setting, data; T800 root, w[3]; C004 sw;
        connect sun.bus[0] to vme.slot[1];
        connect setting.bus[0] to vme.slot[2]; connect data.bus[0] to vme.slot[2];
        connect setting.link[0] to sw.config; connect data.link[0] to root.link[1];
        connect root.link[0] to sw.link[0];
        process (interface (input commands, output answers)) logic;
        process (interface (output commands, input answers, output out[3], input in[3])) visitor;
        process (interface (input in[3], output out[3], input answers_in[3], output answers_out[3])) agent;
        process (interface (input in, output out)) echo[3];
        use "csp.switch_logic" for logic; use "csp.switching_producer" for visitor; use "test.agent" for agent;
        use "csp.identity" for echo;
        visitor (count = 4, bytes = 30); agent (count = 4); echo (count = 4);
        connect visitor.commands to logic.commands; connect logic.answers to visitor.answers;
        place visitor on sun; place logic on sw; place agent on root;
        rep i = 0 for 3 {
            connect w[i].link[0] to sw.link[1 + i]; connect sw.link[1 + i] to sw.link[0];
            connect visitor.out[i] to agent.in[i]; connect agent.answers_out[i] to visitor.in[i];
            connect agent.out[i] to echo[i].in; connect echo[i].out to agent.answers_in[i];
            place echo[i] on w[i];
        })";
    auto read = [&](const std::string& netlist) {
        ReadResult result = read_netlist_text(netlist, kinds, {});
        INFO(render(result));
        REQUIRE(result.network);
        return *result.network;
    };
    Network network = read(text);
    CHECK(read(print_cfs(network)).hash == network.hash);
    RunReport report = Machine(network, kinds, 1).run();
    CHECK(report.result.ending == Ending::completed);
    CHECK(report.measured("visitor", "wrong_answers") == 0);
    REQUIRE(report.switches.size() == 1);
    CHECK(report.switches[0].commands == 4 * 3 * 4);
    CHECK(report.switches[0].connections == 4 * 3 * 2);
    CHECK(report.switches[0].losses.empty());
    for (const LinkUse& link : report.links)
        if (link.from == "setting.link[0]")
            CHECK(link.bytes == 4 * 3 * (3 + 1 + 2 + 3));
        else if (link.from == "sw.config")
            CHECK(link.bytes == 4 * 3);
    // status and data accesses for its nine bytes and the answer
    CHECK(report.measured("visitor", "setting_per_visit") > 2 * (9 + 1) * 1.71);
}

TEST_CASE("a host that polls an adapter has a data rate within the range of real machines") {
    auto rate = [](const char* from, const char* to) {
        std::string text = R"(workstation (clock = 25M) sun; VME vme; C012 adapter; T800 t;
            connect sun.bus[0] to vme.slot[1]; connect adapter.bus[0] to vme.slot[2];
            connect adapter.link[0] to t.link[0];
            process (interface (output out)) p; process (interface (input in)) c;
            use "csp.producer" for p; use "csp.consumer" for c; p (count = 3, bytes = 10000); c (count = 3);
            connect p.out to c.in; place p on )" +
                           std::string(from) + "; place c on " + to + ";";
        return Machine(network_with_bus(text), csp_catalogue(), 1).run().measured("c", "rate");
    };
    for (double each : {rate("sun", "t"), rate("t", "sun")}) {
        CHECK(each > 43);
        CHECK(each < 400);
    }
}
