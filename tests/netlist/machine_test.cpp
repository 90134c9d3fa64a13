// A netlist as a machine that runs.

#include "netlist/kinds/csp_kinds.hpp"
#include "netlist/machine.hpp"
#include "netlist/read.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>

#include <fmt/format.h>

using namespace placedpar;

namespace {

/// Runs a producer on the one transputer and a consumer on the other.
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

TEST_CASE("links of transputers that do not overlap acknowledges carry 0.8 Mbyte/s, others 1.74") {
    for (const char* type : {"T800", "T805", "T801", "T425", "T400", "T222", "T225", "t800", "B404"})
        CHECK(rate(type, "T800") == doctest::Approx(1740).epsilon(0.01));
    for (const char* type : {"T414", "t414", "T212", "B402", "M212"}) {
        CHECK(rate(type, "T800") == doctest::Approx(800).epsilon(0.03));
        CHECK(rate("T800", type) == doctest::Approx(800).epsilon(0.03));
    }
    CHECK(rate("processor (type = \"T414\")", "T414") == doctest::Approx(800).epsilon(0.03));
}

TEST_CASE("what can be shown but not run says where it is") {
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
    CHECK(refusal(process) == "m.cfs:2:44: process p has no program: say use \"kind\" for p;");
    CHECK(refusal(process + " use \"mine.lku\" for p;")
              .starts_with("m.cfs:2:44: process p runs \"mine.lku\", a program that PlacedPar does not have"));
    CHECK(refusal("output o; process (interface (output out)) p; use \"csp.producer\" for p; place p on a;\n"
                  "place o on e; connect p.out to o;")
              .starts_with("m.cfs:3:15: channel p.out -> o leads to an edge"));
}

TEST_CASE("what a process refuses is the user's error at its place; its defects stay defects") {
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
    CHECK_THROWS_WITH_AS(run([] { throw std::invalid_argument("a population of -1"); }), "a population of -1",
                         std::invalid_argument);
    CHECK_THROWS_AS(run([] { throw std::out_of_range("at"); }), std::out_of_range);
}

TEST_CASE("a machine that would compute for longer than virtual time lasts says so and ends") {
    CHECK_THROWS_WITH_AS(run_pair("T800 (clock = 1)", "T800 (clock = 1)", "count = 10, cycles = 1000000000000"),
                         doctest::Contains("would pass that end: shorten its computation or delay"), UserError);
}
