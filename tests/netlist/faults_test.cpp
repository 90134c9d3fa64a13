// Faults stated by a netlist, and what they do to its run.

#include "netlist/kinds/csp_kinds.hpp"
#include "netlist/kinds/fault_kinds.hpp"
#include "netlist/machine.hpp"
#include "netlist/print/print.hpp"
#include "netlist/read.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace placedpar;

namespace {

/// A stream of 100 packets from a to b, and what else is said.
std::string stream(const std::string& more, bool recovers = false) {
    std::string from = recovers ? "sender_or_fail" : "producer", to = recovers ? "receiver_or_fail" : "consumer";
    return R"(val at 2ms; T800 a, b; connection wire; connect a.link[0] to b.link[0] by wire;
        process (interface (output out)) p; process (interface (input in)) c;
        use "csp.)" +
           from + R"(" for p; use "csp.)" + to + R"(" for c;
        p (count = 100, bytes = 200); c (count = 100);
        connect p.out to c.in; place p on a; place c on b;)" +
           more;
}

Catalogue csp() {
    Catalogue catalogue;
    add_csp_kinds(catalogue);
    return catalogue;
}

Network network_of_stream(const std::string& text, const Overrides& set = {},
                          const std::vector<std::string>& faults = {}) {
    ReadResult read = read_netlist_text(text, csp(), set, "netlist", {.faults = faults});
    INFO(render(read));
    REQUIRE(read.network);
    return *read.network;
}

std::string only_fault(const Network& network) {
    REQUIRE(network.faults.size() == 1);
    return print_fault(network.faults[0], network.nodes);
}

RunReport run_stream(const std::string& more, bool recovers = false) {
    return Machine(network_of_stream(stream(more, recovers)), csp(), 1).run();
}

} // namespace

TEST_CASE("a fault is of a link, of the wire of a connection, or of a device; times have units") {
    for (auto [said, printed] : std::vector<std::pair<const char*, const char*>>{
             {"fault a.link[0] silent;", "a.link[0] silent"},
             {"fault wire silent (from = 20ms, until = 1s);", "a.link[0] silent (from = 20ms, until = 1s)"},
             {"fault b.link[0] silent (from = 1.5us, direction = \"in\");",
              "b.link[0] silent (from = 1500ns, direction = \"in\")"},
             {"fault wire loses_acknowledge (from = at);", "a.link[0] loses_acknowledge (from = 2ms)"},
             {"fault wire slow (factor = 4, from = 20 * 1us);", "a.link[0] slow (from = 20us, factor = 4)"},
             {"fault b halts (from = 3000000);", "b halts (from = 3ms)"}}) {
        CAPTURE(said);
        Network network = network_of_stream(stream(said));
        CHECK(only_fault(network) == printed);
        Network again = network_of_stream(print_cfs(network));
        CHECK(only_fault(again) == printed);
        CHECK(again.hash == network.hash);
        CHECK(network.hash != network_of_stream(stream("")).hash);
        CHECK(print_json(network).find("\"faults\": [") != std::string::npos);
    }
}

TEST_CASE("an option states a fault in the words of the statement, and --set reaches its numbers") {
    Network said = network_of_stream(stream("fault wire silent (from = at);"), {{"at", "5ms"}});
    Network option = network_of_stream(stream(""), {}, {"wire silent (from = 5ms)"});
    CHECK(only_fault(said) == "a.link[0] silent (from = 5ms)");
    CHECK(option.hash == said.hash);
    ReadResult wrong = read_netlist_text(stream(""), csp(), {}, "netlist", {.faults = {"wire silent from 5ms"}});
    CHECK(render(wrong) == "--fault:1:13: error: illegal token behind a fault: \"from\"\n"
                           "    wire silent from 5ms\n"
                           "                ^\n"
                           "hint: --fault 't[0].link[1] silent (from = 20ms)'\n");
}

TEST_CASE("old netlists may use the word as a name") {
    ReadResult read = read_netlist_text("define T800 (memory = 1M) fault; fault a, b; connect a.link[0] to b.link[0];"
                                        "val silent 3; T800 c[silent]; rep i = 0 for 3 connect c[i].link[0] to "
                                        "a.link[i + 1];",
                                        csp(), {});
    CHECK(render(read) == "");
    read = read_netlist_text("T800 fault, b; connect fault.link[0] to b.link[0];", csp(), {});
    CHECK(render(read) == "");
}

TEST_CASE("a silent link is a deadlock, and the report says which message it took") {
    RunReport report = run_stream("fault wire silent (from = at); fault a.link[0] slow (from = 1s, factor = 2);");
    CHECK(report.result.ending == Ending::stuck);
    REQUIRE(report.faults.size() == 2);
    const FaultUse& silent = report.faults[0];
    CHECK(silent.bytes_lost + silent.acknowledges_lost == 1);
    REQUIRE(silent.first);
    CHECK(silent.first->channel == "p.out -> c.in");
    CHECK(silent.first->at >= std::chrono::milliseconds{2});
    CHECK(silent.first->at < std::chrono::microseconds{2001});
    CHECK(!report.faults[1].had_effect());
    CHECK(report.result.deadlock->processes.size() == 2);
}

TEST_CASE("the direction is seen from the end that is named") {
    for (auto [fault, bytes] : std::vector<std::pair<const char*, std::uint64_t>>{
             {"fault a.link[0] silent (from = at, direction = \"out\");", 1},
             {"fault b.link[0] silent (from = at, direction = \"in\");", 1},
             {"fault a.link[0] silent (from = at, direction = \"in\");", 0},
             {"fault b.link[0] silent (from = at, direction = \"out\");", 0}}) {
        CAPTURE(fault);
        RunReport report = run_stream(fault);
        CHECK(report.faults[0].bytes_lost == bytes);
        CHECK(report.faults[0].acknowledges_lost == 1 - bytes);
    }
}

TEST_CASE("a slow link takes longer, a link that was slow for a while less so") {
    double sound = in_milliseconds(run_stream("").result.time);
    double slow = in_milliseconds(run_stream("fault wire slow (factor = 4);").result.time);
    double for_a_while = in_milliseconds(run_stream("fault wire slow (factor = 4, until = 2ms);").result.time);
    CHECK(slow > 3.4 * sound); // a part of the restart is logic that does not slow down
    CHECK(slow < 4 * sound);
    CHECK(for_a_while > sound + 1.4);
    CHECK(for_a_while < sound + 1.6);
}

TEST_CASE("a processor that halts stops its processes, and those that wait for it are named") {
    RunReport report = run_stream("fault a halts (from = at);");
    CHECK(report.result.ending == Ending::stuck);
    REQUIRE(report.faults.size() == 1);
    CHECK(report.faults[0].stopped == std::vector<std::string>{"p"});
    REQUIRE(report.result.deadlock->processes.size() == 2);
    CHECK(report.result.deadlock->processes[0].activity == Activity::halted);
    CHECK(report.result.deadlock->processes[1].activity == Activity::inputting);
    CHECK(run_stream("fault a halts (from = 1s);").faults[0].had_effect() == false);
}

TEST_CASE("a stream with time-outs survives what a stream without does not, and counts what is lost") {
    for (const char* fault :
         {"fault wire silent (from = at, until = 5ms);", "fault wire loses_acknowledge (from = at);",
          "fault wire silent (from = at, until = 5ms, direction = \"out\");"}) {
        CAPTURE(fault);
        CHECK(run_stream(fault).result.ending == Ending::stuck);
        RunReport report = run_stream(fault, true);
        CHECK(report.result.ending == Ending::completed);
        CHECK(report.measured("p", "given_up") >= 1);
        CHECK(report.measured("c", "received") + report.measured("c", "lost") == 100);
        CHECK(report.measured("c", "lost") <= report.measured("p", "given_up"));
    }
    RunReport sound = run_stream("", true);
    CHECK(sound.measured("c", "received") == 100);
    CHECK(sound.measured("p", "given_up") == 0);
}

namespace {

/// Two bus masters, of which one writes to the other, and what else is said.
std::string bus_of_two(const std::string& more, const std::string& arbiter = "PRI") {
    return "VME (arbiter = \"" + arbiter + R"(") vme; BBKV2 a, b; connect a.bus[0] to vme.slot[1];
        connect b.bus[0] to vme.slot[21];
        process (interface (output out)) p; process (interface (input in)) c;
        use "csp.producer" for p; use "csp.consumer" for c; p (count = 20, bytes = 400); c (count = 20);
        connect p.out to c.in; place p on a; place c on b;)" +
           more;
}

RunReport run_on_bus(const std::string& more) { return Machine(network_of_stream(bus_of_two(more)), csp(), 1).run(); }

} // namespace

TEST_CASE("a bus that another master hogs is waited for, from its grant to its end, and the report says since when") {
    RunReport free = run_on_bus("");
    RunReport hogged = run_on_bus("fault vme hogged (from = 100us, until = 5ms);");
    CHECK(hogged.result.ending == Ending::completed);
    REQUIRE(hogged.faults.size() == 1);
    CHECK(hogged.faults[0].fault == "vme hogged (from = 100us, until = 5ms)");
    REQUIRE(hogged.faults[0].held_since);
    Time since = *hogged.faults[0].held_since, end = std::chrono::milliseconds{5};
    CHECK(since > std::chrono::microseconds{100});
    CHECK(since < std::chrono::microseconds{150}); // a block of 100 words that is under way
    CHECK(hogged.result.time > free.result.time + (end - since) - std::chrono::microseconds{150});
    CHECK(hogged.result.time < free.result.time + (end - since) + std::chrono::microseconds{2});
    REQUIRE(hogged.buses[0].masters.size() == 3);
    CHECK(hogged.buses[0].masters[2].name == "slot 20");
    CHECK(hogged.buses[0].masters[2].grants == 1);
    CHECK(hogged.buses[0].masters[0].longest_wait > Time{end - since} - std::chrono::microseconds{150});
    CHECK(run_on_bus("fault vme hogged (from = 1s, until = 2s);").faults[0].had_effect() == false);
}

TEST_CASE("two hogs stand in two slots, and what is printed of one loads again") {
    Network network = network_of_stream(
        bus_of_two("fault vme hogged (until = 1ms, level = 0); fault vme hogged (from = 2ms, until = 3ms);"));
    Network again = network_of_stream(print_cfs(network));
    CHECK(again.hash == network.hash);
    CHECK(print_fault(network.faults[0], network.nodes) == "vme hogged (until = 1ms, level = 0)");
    RunReport report = Machine(network, csp(), 1).run();
    CHECK(report.buses[0].masters.size() == 4);
    CHECK(report.faults[0].held_since);
    CHECK(report.faults[1].held_since);
    auto refused = [](const std::string& text) { return render(read_netlist_text(text, csp())); };
    CHECK(refused(bus_of_two("fault vme hogged (until = 1ms, level = 2);", "SGL"))
              .find("\"vme\" has the arbiter SGL: there is only level 3") != std::string::npos);
    CHECK(refused(bus_of_two("fault vme hogged;")).find("needs the attribute \"until\"") != std::string::npos);
    CHECK(refused(bus_of_two("fault vme hogged (from = 2ms, until = 1ms);")).find("over before it begins") !=
          std::string::npos);
    CHECK(refused(bus_of_two("fault vme halts;")).find("a bus has no fault \"halts\"") != std::string::npos);
    CHECK(refused(bus_of_two("rep i = 0 for 20 fault vme hogged (until = 1ms);")).find("no slot of \"vme\" is free") !=
          std::string::npos);
}
