// Tests faults stated in a netlist, and their effect on a run.

#include "netlist/kinds/csp_kinds.hpp"
#include "netlist/kinds/fault_kinds.hpp"
#include "netlist/machine.hpp"
#include "netlist/print/print.hpp"
#include "netlist/read.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace placedpar;

namespace {

/// A stream of 100 packets from a to b, with additional statements.
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

TEST_CASE("a fault applies to a link, a connection's wire or a device; times have units") {
    for (const auto& each : std::vector<std::pair<std::string, std::string>>{
             {"fault a.link[0] silent;", "a.link[0] silent"},
             {"fault wire silent (from = 20ms, until = 1s);", "a.link[0] silent (from = 20ms, until = 1s)"},
             {"fault b.link[0] silent (from = 1.5us, direction = \"in\");",
              "b.link[0] silent (from = 1500ns, direction = \"in\")"},
             {"fault wire loses_acknowledge (from = at);", "a.link[0] loses_acknowledge (from = 2ms)"},
             {"fault wire slow (factor = 4, from = 20 * 1us);", "a.link[0] slow (from = 20us, factor = 4)"},
             {"fault b halts (from = 3000000);", "b halts (from = 3ms)"}}) {
        CAPTURE(each.first);
        Network network = network_of_stream(stream(each.first));
        CHECK(only_fault(network) == each.second);
        Network again = network_of_stream(print_cfs(network));
        CHECK(only_fault(again) == each.second);
        CHECK(again.hash == network.hash);
        CHECK(network.hash != network_of_stream(stream("")).hash);
        CHECK(print_json(network).find("\"faults\": [") != std::string::npos);
    }
}

TEST_CASE("--fault takes the words of the fault statement, and --set changes its numbers") {
    Network said = network_of_stream(stream("fault wire silent (from = at);"), {{"at", "5ms"}});
    Network option = network_of_stream(stream(""), {}, {"wire silent (from = 5ms)"});
    CHECK(only_fault(said) == "a.link[0] silent (from = 5ms)");
    CHECK(option.hash == said.hash);
    ReadResult wrong = read_netlist_text(stream(""), csp(), {}, "netlist", {.faults = {"wire silent from 5ms"}});
    CHECK(render(wrong) == "--fault:1:13: error: illegal token after a fault: \"from\"\n"
                           "    wire silent from 5ms\n"
                           "                ^\n"
                           "hint: --fault 't[0].link[1] silent (from = 20ms)'\n");
}

TEST_CASE("old netlists may use fault as a name") {
    ReadResult read = read_netlist_text("define T800 (memory = 1M) fault; fault a, b; connect a.link[0] to b.link[0];"
                                        "val silent 3; T800 c[silent]; rep i = 0 for 3 connect c[i].link[0] to "
                                        "a.link[i + 1];",
                                        csp(), {});
    CHECK(render(read) == "");
    read = read_netlist_text("T800 fault, b; connect fault.link[0] to b.link[0];", csp(), {});
    CHECK(render(read) == "");
}

TEST_CASE("a silent link causes a deadlock, and the report names the lost message") {
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

TEST_CASE("a fault's direction is relative to the named end") {
    for (const auto& each : std::vector<std::pair<std::string, std::uint64_t>>{
             {"fault a.link[0] silent (from = at, direction = \"out\");", 1},
             {"fault b.link[0] silent (from = at, direction = \"in\");", 1},
             {"fault a.link[0] silent (from = at, direction = \"in\");", 0},
             {"fault b.link[0] silent (from = at, direction = \"out\");", 0}}) {
        CAPTURE(each.first);
        RunReport report = run_stream(each.first);
        CHECK(report.faults[0].bytes_lost == each.second);
        CHECK(report.faults[0].acknowledges_lost == 1 - each.second);
    }
}

TEST_CASE("a slow link delays messages; a temporarily slow link delays them less") {
    double sound = in_milliseconds(run_stream("").result.time);
    double slow = in_milliseconds(run_stream("fault wire slow (factor = 4);").result.time);
    double for_a_while = in_milliseconds(run_stream("fault wire slow (factor = 4, until = 2ms);").result.time);
    CHECK(slow > 3.4 * sound); // part of the restart is logic, which is not slowed down
    CHECK(slow < 4 * sound);
    CHECK(for_a_while > sound + 1.4);
    CHECK(for_a_while < sound + 1.6);
}

TEST_CASE("a halted processor stops its processes, and the report names the processes that wait for it") {
    RunReport report = run_stream("fault a halts (from = at);");
    CHECK(report.result.ending == Ending::stuck);
    REQUIRE(report.faults.size() == 1);
    CHECK(report.faults[0].stopped == std::vector<std::string>{"p"});
    REQUIRE(report.result.deadlock->processes.size() == 2);
    CHECK(report.result.deadlock->processes[0].activity == Activity::halted);
    CHECK(report.result.deadlock->processes[1].activity == Activity::inputting);
    CHECK(run_stream("fault a halts (from = 1s);").faults[0].had_effect() == false);
}

TEST_CASE("a stream with time-outs survives a fault that stops a stream without time-outs, and counts losses") {
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

/// A bus master that writes to another bus master, with additional statements.
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

TEST_CASE("masters wait for a bus that another master hogs, and the report says since when") {
    RunReport free = run_on_bus("");
    RunReport hogged = run_on_bus("fault vme hogged (from = 100us, until = 5ms);");
    CHECK(hogged.result.ending == Ending::completed);
    REQUIRE(hogged.faults.size() == 1);
    CHECK(hogged.faults[0].fault == "vme hogged (from = 100us, until = 5ms)");
    REQUIRE(hogged.faults[0].held_since);
    Time since = *hogged.faults[0].held_since, end = std::chrono::milliseconds{5};
    CHECK(since > std::chrono::microseconds{100});
    CHECK(since < std::chrono::microseconds{150}); // a block of 100 words is being moved
    CHECK(hogged.result.time > free.result.time + (end - since) - std::chrono::microseconds{150});
    CHECK(hogged.result.time < free.result.time + (end - since) + std::chrono::microseconds{2});
    REQUIRE(hogged.buses[0].masters.size() == 3);
    CHECK(hogged.buses[0].masters[2].name == "slot 20");
    CHECK(hogged.buses[0].masters[2].grants == 1);
    CHECK(hogged.buses[0].masters[0].longest_wait > Time{end - since} - std::chrono::microseconds{150});
    CHECK(run_on_bus("fault vme hogged (from = 1s, until = 2s);").faults[0].had_effect() == false);
}

TEST_CASE("an access to an absent device on a bus ends in a bus error after the bus's time-out") {
    auto refused_with = [](const std::string& more) -> std::string {
        try {
            run_on_bus(more);
        } catch (const UserError& error) {
            return error.what();
        }
        return "";
    };
    std::string said = refused_with("fault b absent (from = 100us);");
    CHECK(said.find("process p (csp.producer) at ") != std::string::npos);
    CHECK(said.find("bus error: b does not answer a on bus vme within 125.000000 us") != std::string::npos);
    CHECK(refused_with("fault b absent (from = 1s);").empty());
    CHECK(refused_with("fault b absent (until = 100us); fault b absent (from = 1s);").find(" at 1") !=
          std::string::npos);                       // both faults count, not only the last
    CHECK(refused_with("fault a absent;").empty()); // no master accesses it
    CHECK(run_on_bus("fault b absent (from = 1s);").faults[0].had_effect() == false);
}

TEST_CASE("a router's access to an absent device ends in a bus error, like a program's") {
    std::string said;
    try {
        Machine(network_of_stream(R"(workstation sun; VME vme; C011 ad; T800 a, b; connect sun.bus[0] to vme.slot[1];
            connect ad.bus[0] to vme.slot[5]; connect ad.link[0] to a.link[0]; connect a.link[1] to b.link[0];
            process p, c; use "csp.producer" for p; use "csp.consumer" for c; p (count = 10); c (count = 10);
            connect p.out to c.in; place p on sun; place c on b; fault ad absent (from = 100us);)"),
                csp(), 1)
            .run();
    } catch (const UserError& error) {
        said = error.what();
    }
    CHECK(said.find("router ") != std::string::npos);
    CHECK(said.find("bus error: ad does not answer sun on bus vme within 125.000000 us") != std::string::npos);
}

TEST_CASE("two hogging masters take two slots, and a printed network with hogging masters loads again") {
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
              .find("\"vme\" has the arbiter SGL, which has only level 3") != std::string::npos);
    CHECK(refused(bus_of_two("fault vme hogged;")).find("needs the attribute \"until\"") != std::string::npos);
    CHECK(refused(bus_of_two("fault vme hogged (from = 2ms, until = 1ms);")).find("ends before it begins") !=
          std::string::npos);
    CHECK(refused(bus_of_two("fault vme halts;")).find("a bus has no fault \"halts\"") != std::string::npos);
    CHECK(refused(bus_of_two("rep i = 0 for 20 fault vme hogged (until = 1ms);")).find("no slot of \"vme\" is free") !=
          std::string::npos);
}

namespace {

/// A stream from a workstation through a link adapter to a transputer, or in the opposite direction.
std::string stream_by_adapter(bool down, bool recovers, const std::string& more) {
    std::string from = recovers ? "sender_or_fail" : "producer", to = recovers ? "receiver_or_fail" : "consumer";
    return R"(workstation sun; VME vme; C011 adapter; T800 t; connect sun.bus[0] to vme.slot[1];
        connect adapter.bus[0] to vme.slot[2]; connect adapter.link[0] to t.link[0];
        process (interface (output out)) p; process (interface (input in)) c; use "csp.)" +
           from + R"(" for p; use "csp.)" + to + R"(" for c; p (count = 50, bytes = 40); c (count = 50);
        connect p.out to c.in; place p on )" +
           (down ? "sun; place c on t;" : "t; place p.out on t.link[0]; place c on sun;") + more;
}

RunReport run_text(const std::string& text) { return Machine(network_of_stream(text), csp(), 1).run(); }

} // namespace

TEST_CASE("a fault at a link adapter, or at the transputer behind the adapter, causes a deadlock with a named loss") {
    for (bool down : {true, false})
        for (std::string at : {"adapter.link[0]", "t.link[0]"})
            for (std::string fault : {"silent (from = 2ms)", "loses_acknowledge (from = 2ms)"}) {
                CAPTURE(down);
                CAPTURE(at);
                CAPTURE(fault);
                RunReport report = run_text(stream_by_adapter(down, false, "fault " + at + " " + fault + ";"));
                CHECK(report.result.ending == Ending::stuck);
                REQUIRE(report.faults[0].first);
                CHECK(report.faults[0].first->channel == "p.out -> c.in");
                CHECK(report.faults[0].first->byte >= 1);
                CHECK(report.faults[0].first->byte <= 40);
                CHECK(report.result.deadlock->processes.size() >= 1);
            }
}

TEST_CASE("a slow link at an adapter only delays a stream, and a stream with time-outs survives a failing link") {
    for (bool down : {true, false}) {
        CAPTURE(down);
        RunReport sound = run_text(stream_by_adapter(down, false, ""));
        RunReport slow = run_text(stream_by_adapter(down, false, "fault t.link[0] slow (factor = 200);"));
        CHECK(slow.result.ending == Ending::completed);
        CHECK(slow.result.time > 2 * sound.result.time);
        RunReport survived =
            run_text(stream_by_adapter(down, true, "fault adapter.link[0] silent (from = 2ms, until = 5ms);"));
        CHECK(survived.result.ending == Ending::completed);
        CHECK(survived.measured("p", "given_up") >= 1);
        CHECK(survived.measured("c", "received") + survived.measured("c", "lost") == 50);
        CHECK(survived.measured("c", "received") >= 25);
    }
}

namespace {

/// Two streams that pass through b, and one stream that does not.
std::string routed_streams(const std::string& more) {
    return R"(T800 a, b, c, d; connect a.link[0] to b.link[0]; connect b.link[1] to c.link[0];
        connect a.link[2] to d.link[0];
        process (interface (output out)) p[3]; process (interface (input in)) q[3];
        use "csp.producer" for p; use "csp.consumer" for q; p (count = 30, bytes = 300); q (count = 30);
        rep i = 0 for 3 { connect p[i].out to q[i].in; place p[i] on a; }
        place q[0] on c; place q[1] on c; place q[2] on d;)" +
           more;
}

const std::vector<std::string> over_b{"p[0].out -> q[0].in", "p[1].out -> q[1].in"};

} // namespace

TEST_CASE("a fault of a routed link stops only the channels over it, which the report names") {
    for (std::string link : {"a.link[0]", "b.link[0]", "b.link[1]", "c.link[0]"}) {
        CAPTURE(link);
        RunReport report = run_text(routed_streams("fault " + link + " silent (from = 3ms);"));
        CHECK(report.result.ending == Ending::stuck);
        const FaultUse& use = report.faults[0];
        REQUIRE(use.first);
        CHECK(use.first->message != hardware::FaultEffect::Hit::Message::whole);
        CHECK(use.stopped_channels == over_b);
        CHECK(report.result.deadlock->processes.size() == 4);
        CHECK(report.measured("q[2]", "last_number") == 29);
    }
    RunReport slow = run_text(routed_streams("fault b.link[1] slow (factor = 5);"));
    CHECK(slow.result.ending == Ending::completed);
    CHECK(slow.faults[0].stopped_channels.empty());
}

TEST_CASE("a halted processor stops the channels that it passes on, which the report names") {
    RunReport report = run_text(routed_streams("fault b halts (from = 3ms);"));
    CHECK(report.result.ending == Ending::stuck);
    CHECK(report.faults[0].stopped.empty());
    CHECK(report.faults[0].stopped_channels == over_b);
    CHECK(report.faults[0].had_effect());
    CHECK(report.result.deadlock->processes.size() == 4);
}

TEST_CASE("a time-out on a channel that cannot be given up is refused with the reason") {
    auto refused = [](std::string text) {
        for (std::size_t at = 0; (at = text.find("csp.producer", at)) != std::string::npos;)
            text.replace(at, 12, "csp.sender_or_fail");
        return render(read_netlist_text(text, csp()));
    };
    std::string message = refused(routed_streams(""));
    CHECK(message.find("the channel \"p[0].out -> q[0].in\" is carried in packets, which cannot be taken back, so "
                       "its process cannot give up a packet") != std::string::npos);
    CHECK(message.find("hint: a time-out needs a channel between processes on one processor, or a channel placed alone "
                       "on a link") != std::string::npos);
    CHECK(refused(bus_of_two("")).find("leads through the memory of a bus master") != std::string::npos);
}
