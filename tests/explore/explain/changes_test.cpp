// Tests the changes that `explain` tries, and their effect on a small machine.

#include "explore/explain/changes.hpp"

#include "explore/explain/what_if.hpp"
#include "explore/problems.hpp"
#include "netlist/read.hpp"
#include "tests/scratch.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

using namespace placedpar;

namespace {

/// Two processors and a link; the producer computes while the consumer waits, then sends.
constexpr const char* two_processors =
    "T800 a, b; connect a.link[0] to b.link[0];\n"
    "process p, c; use \"csp.producer\" for p; use \"csp.consumer\" for c;\n"
    "p (count = 20, bytes = 1000, cycles = 20000); c (count = 20); place p on a; place c on b; connect p.out to c.in;";

const Catalogue& all_kinds() {
    static const ProblemRegistry problems = known_problems(1);
    static const Catalogue kinds = known_kinds(problems);
    return kinds;
}

Network network_with(const std::string& text) {
    ReadResult result = read_netlist_text(text, all_kinds(), {}, "no-such-file.cfs");
    CAPTURE(render(result));
    REQUIRE(result.network);
    return std::move(*result.network);
}

/// Returns the changed netlist. Throws UserError if it is refused.
Network changed(const Overrides& set) {
    ReadResult result = read_netlist_text(two_processors, all_kinds(), set);
    if (!result.network)
        throw UserError(render(result));
    return std::move(*result.network);
}

/// The netlist has no vals, so overrides declare no further processes or processors.
Declared nothing_more(const Overrides&) { return {}; }

std::vector<Change> changes_of_text(const std::string& text) {
    const Network network = network_with(text);
    return changes_of(network, run_netlist(network, all_kinds(), {}), nothing_more);
}

const Change* find_change(const std::vector<Change>& changes, const std::string& what, const std::string& change) {
    auto found =
        std::ranges::find_if(changes, [&](const Change& each) { return each.what == what && each.change == change; });
    return found == changes.end() ? nullptr : &*found;
}

} // namespace

TEST_CASE("the changes include faster processors: all processors, each array and each processor, at three speeds") {
    const std::vector<Change> changes = changes_of_text(two_processors);
    const Change* both = find_change(changes, "all processors", "twice as fast");
    REQUIRE(both);
    CHECK(both->set == Overrides{{"a.clock", "40000000"}, {"b.clock", "40000000"}});
    const Change* one = find_change(changes, "processor of p", "10 % faster");
    REQUIRE(one);
    CHECK(one->set == Overrides{{"a.clock", "22000000"}});
    const Change* most = find_change(changes, "processor of c", "as fast as can be");
    REQUIRE(most);
    CHECK(most->set == Overrides{{"b.clock", "1000000000"}});
}

TEST_CASE("each change is tried once") {
    const std::vector<Change> changes = changes_of_text(two_processors);
    for (std::size_t i = 0; i < changes.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            CHECK_FALSE((changes[i].set == changes[j].set ||
                         (changes[i].what == changes[j].what && changes[i].change == changes[j].change)));
}

TEST_CASE("every change sets an existing parameter to a value that the netlist accepts") {
    for (const Change& change : changes_of_text(two_processors)) {
        CAPTURE(change.what);
        CAPTURE(change.change);
        CHECK_FALSE(change.set.empty());
        if (change.change != "none")
            CHECK_NOTHROW(changed(change.set));
    }
}

TEST_CASE("the answers begin with the shortest run, and a change without effect leaves the time equal") {
    const Network network = network_with(two_processors);
    const Time now = run_netlist(network, all_kinds(), {}).result.time;
    const std::vector<Change> changes{
        {Change::Of::all, "nothing", "as it is", {}},
        {Change::Of::alone, "p", "half", {{"p.cycles", "10000"}}},
        {Change::Of::alone, "p", "less", {{"p.cycles", "0"}}},
        {Change::Of::alone, "p", "refused", {{"p.cycles", "-1"}}},
    };
    const Interruption none;
    const std::vector<Answer> answers =
        try_out(changes, {}, {changed, 1, Time::max(), none, [](std::size_t, std::size_t) {}, 2});
    REQUIRE(answers.size() == 4);
    CHECK(answers[0].change.change == "less");
    CHECK(answers[1].change.change == "half");
    CHECK(answers[2].time == now);
    CHECK(answers[0].time < answers[1].time);
    CHECK(answers[1].time < now);
    CHECK(answers[3].refused.find("out of range") != std::string::npos);
}

namespace {

constexpr const char* one_wire_through_switch =
    "T800 a, b; C004 sw;\n"
    "connect a.link[0] to sw.link[3]; connect sw.link[7] to b.link[1]; connect sw.link[3] to sw.link[7];\n"
    "process p, c; use \"csp.producer\" for p; use \"csp.consumer\" for c;\n"
    "p (count = 20, bytes = 1000); c (count = 20); place p on a; place c on b; connect p.out to c.in;";

/// A link with a name "wire", a link through a switch whose second piece has a speed, and a link without a name.
constexpr const char* three_kinds_of_wires =
    "T800 a, b, d, e; C004 sw; connection (linkspeed = 10M) wire, half;\n"
    "connect a.link[0] to b.link[0] by wire;\n"
    "connect b.link[1] to sw.link[3]; connect sw.link[7] to d.link[1] by half; connect sw.link[3] to sw.link[7];\n"
    "connect d.link[0] to e.link[0];\n"
    "process p, s[2], c; use \"csp.producer\" for p; use \"csp.identity\" for s[0]; use \"csp.identity\" for s[1];\n"
    "use \"csp.consumer\" for c; p (count = 20, bytes = 1000); c (count = 20);\n"
    "place p on a; place s[0] on b; place s[1] on d; place c on e;\n"
    "connect p.out to s[0].in; connect s[0].out to s[1].in; connect s[1].out to c.in;";

/// Returns the speeds of the links, in the netlist's order, after the change "twice as fast".
std::vector<std::int64_t> speeds_after(const std::string& text, const std::string& what) {
    const std::vector<Change> changes = changes_of_text(text);
    const Change* change = find_change(changes, what, "twice as fast");
    REQUIRE(change);
    ReadResult result = read_netlist_text(text, all_kinds(), change->set);
    CAPTURE(render(result));
    REQUIRE(result.network);
    std::vector<std::int64_t> speeds;
    for (const LinkConnection& each : result.network->connections)
        speeds.push_back(each.bits_per_second);
    return speeds;
}

} // namespace

TEST_CASE("a link through a switch is varied, also if it is the only link") {
    CHECK(speeds_after(one_wire_through_switch, "link a.link[0] - b.link[1]") == std::vector<std::int64_t>{40'000'000});
    CHECK_FALSE(find_change(changes_of_text(one_wire_through_switch), "all links", "twice as fast"));
}

TEST_CASE("each link is varied by its own name, and all links together, whatever their speeds") {
    using Speeds = std::vector<std::int64_t>;
    const std::string text = three_kinds_of_wires;
    CHECK(speeds_after(text, "link a.link[0] - b.link[0]") == Speeds{20'000'000, 10'000'000, 20'000'000});
    CHECK(speeds_after(text, "link b.link[1] - d.link[1]") == Speeds{10'000'000, 20'000'000, 20'000'000});
    CHECK(speeds_after(text, "link d.link[0] - e.link[0]") == Speeds{10'000'000, 10'000'000, 40'000'000});
    CHECK(speeds_after(text, "all links") == Speeds{20'000'000, 20'000'000, 40'000'000});
}

TEST_CASE("the only link is varied if a program sets its switch during the run") {
    const std::string text = std::string(one_wire_through_switch) + "connect a.link[1] to sw.config;";
    CHECK(speeds_after(text, "all links").back() == 40'000'000);
}

namespace {

/// Two producers on one processor: the first computes, the second does not.
constexpr const char* one_computes =
    "T800 a; process p[2]; process c[2]; use \"csp.producer\" for p; use \"csp.consumer\" for c;\n"
    "p (count = 20); c (count = 20); p[0] (cycles = 20000); rep i = 0 for 2 { place p[i] on a; place c[i] on a; "
    "connect p[i].out to c[i].in; }\n";

} // namespace

TEST_CASE("a smaller constant leaves alone the processes that have the constant with another value") {
    std::vector<Overrides> of_cycles;
    for (const Change& each : changes_of_text(one_computes))
        if (each.what.find("cycles") != std::string::npos || each.what == "what p[0] computes")
            of_cycles.push_back(each.set);
    CHECK(of_cycles ==
          std::vector<Overrides>{{{"p[0].cycles", "18000"}}, {{"p[0].cycles", "10000"}}, {{"p[0].cycles", "0"}}});
}

TEST_CASE("a change sets parameters and attributes, not a val of the same name") {
    const Scratch folder;
    const std::string vals = "val cycles 7; val linkspeed 10M; val memorycycles 3;\n";
    const ReadResult read = read_netlist(folder.write("n.cfs", vals + two_processors), all_kinds());
    REQUIRE(read.network);
    const std::vector<Change> changes =
        changes_of(*read.network, run_netlist(*read.network, all_kinds(), {}), nothing_more);
    REQUIRE(find_change(changes, "cycles", "half"));
    for (const Change& each : changes)
        for (const char* val : {"cycles", "linkspeed", "memorycycles"})
            CHECK_FALSE_MESSAGE(each.set.contains(val), each.what);
}

TEST_CASE("wires without a name are varied although elements are named wire and wire_2") {
    const std::string text =
        "T800 wire[3]; T800 wire_2; connect wire[0].link[0] to wire[1].link[0]; "
        "connect wire[1].link[1] to wire[2].link[0]; connect wire[2].link[1] to wire_2.link[0];\n"
        "process p, c; use \"csp.producer\" for p; use \"csp.consumer\" for c; p (count = 2); c (count = 2);\n"
        "place p on wire[0]; place c on wire[1]; connect p.out to c.in;";
    const Network network = network_with(text);
    REQUIRE(network.connections.size() >= 2);
    CHECK(network.connections[1].names_for_set == std::vector<std::string>{"wire_3[1]"});
    const std::vector<Change> changes = changes_of_text(text);
    const Change* faster = find_change(changes, "link wire[0].link[0] - wire[1].link[0]", "twice as fast");
    REQUIRE(faster);
    ReadResult result = read_netlist_text(text, all_kinds(), faster->set);
    CAPTURE(render(result));
    REQUIRE(result.network);
    CHECK(result.network->connections[0].bits_per_second == 40'000'000);
}
