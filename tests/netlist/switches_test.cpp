// Tests switches that a program sets while it runs.

#include "netlist/kinds/csp_kinds.hpp"
#include "netlist/kinds/fault_kinds.hpp"
#include "netlist/machine.hpp"
#include "netlist/print/print.hpp"
#include "netlist/read.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

using namespace placedpar;

namespace {

Catalogue kinds_of_switches() {
    Catalogue catalogue;
    add_csp_kinds(catalogue);
    return catalogue;
}

/// A root that visits three other processors through one of its links, with additional statements.
std::string visits(const std::string& more = "") {
    return R"(T800 root, w[3]; C004 sw; connection (length = 2) cable[4];
        connect root.link[3] to sw.config;
        connect root.link[0] to sw.link[0] by cable[3];
        process (interface (input commands, output answers)) logic;
        process (interface (output commands, input answers, output out[3], input in[3])) visitor;
        process (interface (input in, output out)) echo[3];
        use "csp.switch_logic" for logic; use "csp.switching_producer" for visitor; use "csp.identity" for echo;
        visitor (count = 5, bytes = 100); echo (count = 5);
        connect visitor.commands to logic.commands; connect logic.answers to visitor.answers;
        place visitor on root; place logic on sw;
        rep i = 0 for 3 {
            connect w[i].link[0] to sw.link[1 + i] by cable[i];
            connect sw.link[1 + i] to sw.link[0];
            connect visitor.out[i] to echo[i].in; connect echo[i].out to visitor.in[i]; place echo[i] on w[i];
        } )" +
           more;
}

Network network_of_switches(const std::string& text, const Overrides& set = {}) {
    ReadResult read = read_netlist_text(text, kinds_of_switches(), set);
    INFO(render(read));
    REQUIRE(read.network);
    return *read.network;
}

RunReport run_switched(const std::string& text, const Overrides& set = {}) {
    return Machine(network_of_switches(text, set), kinds_of_switches(), 1).run();
}

} // namespace

TEST_CASE("channels use the connections that a program-controlled switch can make") {
    Network network = network_of_switches(visits());
    CHECK(network.connections.size() == 4);
    CHECK(std::ranges::count_if(network.connections, &LinkConnection::at_run_time) == 3);
    CHECK(network.pieces.size() == 4);
    for (int i = 0; i < 3; ++i) {
        auto out = std::ranges::find(network.channels,
                                     "visitor.out[" + std::to_string(i) + "] -> echo[" + std::to_string(i) + "].in",
                                     &NetworkChannel::name);
        REQUIRE(out != network.channels.end());
        REQUIRE(out->placement.route.size() == 1);
        const LinkConnection& over = network.connections[out->placement.route[0].connection];
        CHECK(over.at_run_time);
        CHECK(over.metres == 4);
        CHECK(network.nodes[over.b.node].name == "w[" + std::to_string(i) + "]");
        CHECK(!out->placement.in_packets);
    }
}

TEST_CASE("the printed form of a network with such a switch loads as the same network") {
    Network network = network_of_switches(visits("fault root.link[3] slow (factor = 2); fault cable[1] silent;"));
    std::string printed = print_cfs(network);
    Network again = network_of_switches(printed);
    CHECK(print_cfs(again) == printed);
    CHECK(again.hash == network.hash);
    CHECK(printed.find("connect root.link[3] to sw.config;\n") != std::string::npos);
    CHECK(printed.find("fault w[1].link[0] silent;\n") != std::string::npos);
    CHECK(network.hash != network_of_switches(visits()).hash);
    CHECK(print_json(network).find("\"at_run_time\": true") != std::string::npos);
    CHECK(print_dot(network).find("\"config\"") != std::string::npos);
}

TEST_CASE("a program visits its partners over one switched link, and the switch answers queries") {
    RunReport report = run_switched(visits());
    CHECK(report.result.ending == Ending::completed);
    CHECK(report.measured("visitor", "wrong_answers") == 0);
    REQUIRE(report.switches.size() == 1);
    CHECK(report.switches[0].name == "sw");
    CHECK(report.switches[0].commands == 5 * 3 * 4 - 1); // the last command is acknowledged early
    CHECK(report.switches[0].connections == 5 * 3 * 2);
    CHECK(report.switches[0].losses.empty());
    for (const LinkUse& link : report.links) {
        CAPTURE(link.from);
        bool configures = link.from == "root.link[3]", answers = link.from == "sw.config";
        CHECK(link.bytes == (configures ? 5 * 3 * (3 + 1 + 2 + 3) : answers ? 5 * 3 : 500));
    }
    // three commands of 3, 1 and 3 bytes, and a command of 2 bytes with an answer; a byte takes 560 ns, and a message
    // 950 ns and 360 ns more
    CHECK(report.measured("visitor", "setting_per_visit") == doctest::Approx(4 * 1.31 + 5 * 0.56 + 0.95).epsilon(0.02));
}

TEST_CASE("a message at an unconnected input is lost, and the report names the output") {
    RunReport report = run_switched(visits("visitor (first = 2);"));
    CHECK(report.result.ending == Ending::stuck);
    REQUIRE(report.result.deadlock);
    CHECK(report.result.deadlock->cycle == std::vector<std::string>{"visitor", "echo[0]"});
    REQUIRE(report.switches[0].losses.size() == 1);
    const SwitchUse::Loss& loss = report.switches[0].losses[0];
    CHECK(loss.from == "root.link[0]");
    CHECK(loss.to == "w[0].link[0]");
    CHECK(loss.output == 1);
    CHECK(loss.state == "was connected to no input");
    CHECK(loss.first.channel == "visitor.out[0] -> echo[0].in");
    CHECK(loss.bytes == 1);
}

TEST_CASE("a fault of a switched link affects every partner, a fault of a worker's link only that worker") {
    RunReport all = run_switched(visits("fault root.link[0] slow (factor = 4);"));
    RunReport one = run_switched(visits("fault cable[1] slow (factor = 4);"));
    RunReport none = run_switched(visits());
    double slow = all.measured("visitor", "time"), fast = none.measured("visitor", "time");
    CHECK(slow > 2 * fast);
    CHECK(one.measured("visitor", "time") == doctest::Approx((slow + 2 * fast) / 3).epsilon(0.001));
    RunReport silent = run_switched(visits("fault root.link[3] silent (from = 100us);"));
    CHECK(silent.result.ending == Ending::stuck);
}

TEST_CASE("a switch can be set through another switch and by a distant process") {
    RunReport near = run_switched(visits());
    std::string text = visits();
    std::string direct = "connect root.link[3] to sw.config;";
    auto at = text.find(direct);
    std::string over_switch = text, over_processor = text;
    over_switch.replace(at, direct.size(),
                        "C004 other; connect root.link[3] to other.link[5]; connect other.link[5] to other.link[6];"
                        "connect other.link[6] to sw.config;");
    over_processor.replace(
        at, direct.size(),
        "T800 between; connect root.link[3] to between.link[0]; connect between.link[1] to sw.config;");
    for (const std::string& each : {over_switch, over_processor}) {
        RunReport far = run_switched(each);
        CHECK(far.result.ending == Ending::completed);
        CHECK(far.measured("visitor", "setting_per_visit") > near.measured("visitor", "setting_per_visit"));
    }
}

TEST_CASE("channels prefer fixed wires to switched links unless placed there") {
    std::string wires = "connect root.link[1] to w[0].link[1];";
    Network by_wire = network_of_switches(visits(wires));
    Network placed = network_of_switches(visits(wires + "place visitor.out[0] on root.link[0];"
                                                        "place echo[0].out on w[0].link[0];"));
    auto runs_over_switch = [](const Network& network) {
        return std::ranges::count_if(network.channels, [&](const NetworkChannel& each) {
            return network.connections[each.placement.route[0].connection].at_run_time;
        });
    };
    CHECK(runs_over_switch(by_wire) == 4);
    CHECK(runs_over_switch(placed) == 6);
}
