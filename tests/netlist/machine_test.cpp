// Tests running the machine of a netlist.

#include "netlist/kinds/csp_kinds.hpp"
#include "netlist/machine.hpp"
#include "netlist/read.hpp"
#include "runtime/timer.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>

#include <fmt/format.h>

#include <system_error>

using namespace placedpar;

namespace {

/// Runs a producer on one transputer and a consumer on another.
RunReport run_pair(const std::string& from, const std::string& to, const std::string& producer) {
    Catalogue catalogue;
    add_csp_kinds(catalogue);
    std::string text = fmt::format(R"({} a; {} b; connect a.link[0] to b.link[0];
        process (interface (output out)) p; process (interface (input in)) c;
        use "csp.producer" for p; use "csp.consumer" for c; p ({}); c (count = 10);
        connect p.out to c.in; place p on a; place c on b;)",
                                   from, to, producer);
    ReadResult read = read_netlist_text(text, catalogue, {});
    REQUIRE(read.network);
    return Machine(*read.network, catalogue, 1).run();
}

double rate(const std::string& from, const std::string& to) {
    return run_pair(from, to, "count = 10, bytes = 100000").measured("c", "rate");
}

} // namespace

TEST_CASE("links carry 0.8 Mbyte/s without overlapped acknowledges, 1.74 Mbyte/s with them") {
    for (const char* type : {"T800", "T805", "T801", "T425", "T400", "T222", "T225", "t800", "B404"})
        CHECK(rate(type, "T800") == doctest::Approx(1740).epsilon(0.03));
    for (const char* type : {"T414", "t414", "T212", "B402", "M212"}) {
        CHECK(rate(type, "T800") == doctest::Approx(800).epsilon(0.06));
        CHECK(rate("T800", type) == doctest::Approx(800).epsilon(0.06));
    }
    CHECK(rate("processor (type = \"T414\")", "T414") == doctest::Approx(800).epsilon(0.06));
}

/// Returns how long the memory of `a` was busy with a link over which a producer sends 250,000 words.
Time taken_by_links(const std::string& type) {
    return run_pair(type, "T800", "count = 10, bytes = 100000").processors[0].memory_taken_by_links;
}

TEST_CASE("messages lie in external memory if the memory exceeds the chip's, or if the netlist says so") {
    Time cycles = 250'000 * std::chrono::nanoseconds{50};
    CHECK(taken_by_links("T800") == cycles);
    CHECK(taken_by_links("T800 (memory = 4K)") == cycles);
    for (const char* type : {"B404", "T800 (memory = 1M)", "T805 (memory = 5K)"})
        CHECK(taken_by_links(type) == 3 * cycles);
    CHECK(taken_by_links("T222") == 2 * cycles); // words of two bytes
    CHECK(taken_by_links("T225 (memory = 64K)") == 2 * 2 * cycles);
    CHECK(taken_by_links("B404 (memorycycles = 1)") == cycles);
    CHECK(taken_by_links("T800 (memorycycles = 5)") == 5 * cycles);
}

TEST_CASE("external words of code and data lengthen the computation of a packet by the slower access") {
    auto busy = [](const std::string& type) {
        return run_pair(type, "T800", "count = 10, bytes = 4, cycles = 10000, words = 2000").processors[0].busy;
    };
    constexpr Time cycle = std::chrono::nanoseconds{50};
    CHECK(busy("B404") - busy("T800") == 10 * 2000 * 2 * cycle);
    CHECK(busy("T800 (memorycycles = 5)") - busy("T800") == 10 * 2000 * 4 * cycle);
}

/// Returns when two channels on one link have carried ten messages each, while a process computes at their end.
Time time_in_packets(const std::string& attributes) {
    Catalogue catalogue;
    add_csp_kinds(catalogue);
    std::string text = fmt::format(R"(T800 a; T800 ({}) b; connect a.link[0] to b.link[0];
        process (interface (output out)) p[3]; process (interface (input in)) c[3];
        use "csp.producer" for p; use "csp.consumer" for c; p (count = 10); c (count = 10);
        p[2] (cycles = 2000000);
        rep i = 0 for 3 {{ connect p[i].out to c[i].in; place c[i] on b; }}
        rep i = 0 for 2 place p[i] on a; place p[2] on b;)",
                                   attributes);
    ReadResult read = read_netlist_text(text, catalogue, {});
    REQUIRE(read.network);
    RunReport report = Machine(*read.network, catalogue, 1).run();
    return report.links.at(0).occupied + report.result.time;
}

TEST_CASE("a netlist sets the priority of a processor's router and its cost of a packet") {
    CHECK(time_in_packets("") == time_in_packets("router_priority = HIGH, router_cycles = 200"));
    CHECK(time_in_packets("router_priority = LOW") != time_in_packets(""));
    CHECK(time_in_packets("router_cycles = 1200") > time_in_packets(""));
}

TEST_CASE("the message about a netlist that can only be shown gives the places") {
    auto refusal = [](const std::string& text) -> std::string {
        Catalogue catalogue;
        add_csp_kinds(catalogue);
        ReadResult read = read_netlist_text("T800 a; edge e; connect a.link[0] to e;\n" + text, catalogue, {}, "m.cfs");
        REQUIRE(read.network);
        try {
            Machine(*read.network, catalogue, 1);
        } catch (const UserError& refused) {
            return refused.what();
        }
        return "";
    };
    std::string process = "process (interface (output out, input in)) p;\nplace p on a; connect p.out to p.in;";
    CHECK(refusal(process) == "m.cfs: error: the netlist can be shown, but not run: 1 program is unknown\n"
                              "hint: use \"KIND\" for p;\n"
                              "m.cfs:2:44: note: no program is given to p\n"
                              "    process (interface (output out, input in)) p;\n"
                              "                                               ^\n");
    CHECK(refusal(process + " use \"mine.lku\" for p;").find("m.cfs:2:44: note: \"mine.lku\" is the program of p\n") !=
          std::string::npos);
    CHECK(refusal("output o; process (interface (output out)) p; use \"csp.producer\" for p; place p on a;\n"
                  "place o on e; connect p.out to o;")
              .starts_with("m.cfs: error: the netlist can be shown, but not run: 1 edge has no process\n"));
}

TEST_CASE("one message names all programs that are unknown and all edges that have no process") {
    Catalogue catalogue;
    add_csp_kinds(catalogue);
    auto text =
        "T800 a, b; connect a.link[0] to host; edge far; connect b.link[3] to far; connect a.link[1] to b.link[1];\n"
        "process (interface (input in, output out, log)) m; process (interface (input in, output out)) s[8], t;\n"
        "use \"m.lku\" for m; use \"s.lku\" for s;\n"
        "input keys; output screen; connect keys to m.in; connect m.out to screen; place m.log on host;\n"
        "rep i = 0 for 8 { connect s[i].out to s[(i + 1) % 8].in; place s[i] on b; }\n"
        "output o; input i; connect t.out to o; connect i to t.in; place o on far; place i on far; place t on b;\n"
        "place m on a; place keys on host;";
    ReadResult read = read_netlist_text(text, catalogue, {}, "m.cfs");
    INFO(render(read));
    REQUIRE(read.network);
    std::string said;
    try {
        Machine(*read.network, catalogue, 1);
    } catch (const RefusedInput& refused) {
        said = refused.what();
    }
    CHECK(said.starts_with(
        "m.cfs: error: the netlist can be shown, but not run: 3 programs are unknown, and 2 edges "
        "have no process\n"
        "hint: --use m.lku=KIND runs a kind instead of the program; the command \"kinds\" lists the kinds; use "
        "\"KIND\" for t;; place NAME on far; places a process at the edge\n"));
    for (const char* note :
         {"note: no program is given to t\n", "note: \"m.lku\" is the program of m\n",
          "note: \"s.lku\" is the program of s[0], s[1], s[2], s[3], s[4], s[5] and 2 more\n",
          "note: the edge \"host\" has no process, but these channels lead to it: m.in, m.out, m.log\n",
          "note: the edge \"far\" has no process, but these channels lead to it: t.out, t.in\n"}) {
        CAPTURE(note);
        CHECK(said.find(note) != std::string::npos);
    }
}

TEST_CASE("a process on an edge runs there, as on a workstation") {
    Catalogue catalogue;
    add_csp_kinds(catalogue);
    auto read = [&](const std::string& hardware, const std::string& host) {
        return read_netlist_text(
            "T800 (linkspeed = 10M) a; " + hardware +
                "process p, c; use \"csp.producer\" for p; use \"csp.consumer\" for c;\n"
                "p (count = 10); c (count = 10); connect p.out to c.in; place c on a; place p on " +
                host + ";",
            catalogue, {}, "m.cfs");
    };
    auto at_edge = read("connect a.link[0] to host; ", "host");
    auto by_hand = read("workstation (linkspeed = 10M) sun; connect a.link[0] to sun.link[0]; ", "sun");
    auto named = read("edge sun; connect a.link[0] to sun; ", "sun");
    INFO(render(at_edge));
    REQUIRE(at_edge.network);
    REQUIRE(by_hand.network);
    REQUIRE(named.network);
    CHECK(named.network->hash == by_hand.network->hash);
    auto drawn = read("workstation (linkspeed = 10M) host; connect a.link[0] to host.link[0]; ", "host");
    CHECK(at_edge.network->hash == drawn.network->hash);
    RunReport report = Machine(*at_edge.network, catalogue, 1).run();
    CHECK(report.measured("c", "rate") == Machine(*by_hand.network, catalogue, 1).run().measured("c", "rate"));
}

TEST_CASE("a process's refusal is a user's error with its place in the netlist; other exceptions remain defects") {
    auto run = [](std::function<void()> body) {
        Catalogue catalogue;
        catalogue.add({.name = "mine", .about = "", .body = [body](ProcessEnvironment&) { body(); }});
        ReadResult read =
            read_netlist_text("T800 a; process p; use \"mine\" for p; place p on a;", catalogue, {}, "m.cfs");
        REQUIRE(read.network);
        Machine(*read.network, catalogue, 1).run();
    };
    CHECK_THROWS_WITH_AS(run([] { throw UserError("no such record"); }), "m.cfs:1:17: process p (mine): no such record",
                         UserError);
    CHECK_THROWS_WITH_AS(run([] {
                             wait_for(std::chrono::microseconds{7});
                             throw std::invalid_argument("a population of -1");
                         }),
                         "m.cfs:1:17: process p (mine) at 7.000000 us: a population of -1", std::logic_error);
    CHECK_THROWS_WITH_AS(run([] { throw RefusedInput("data.txt:2:1: error: no number\n"); }),
                         "data.txt:2:1: error: no number\n"
                         "m.cfs:1:17: note: read by process p (mine)\n"
                         "    T800 a; process p; use \"mine\" for p; place p on a;\n"
                         "                    ^\n",
                         RefusedInput);
    CHECK_THROWS_AS(run([] { throw std::system_error(std::make_error_code(std::errc::no_space_on_device)); }),
                    std::system_error);
}

TEST_CASE("a run that would exceed virtual time ends with a message") {
    CHECK_THROWS_WITH_AS(run_pair("T800 (clock = 1)", "T800 (clock = 1)", "count = 10, cycles = 1000000000000"),
                         doctest::Contains("would take longer: shorten its computation or delay"), UserError);
}
