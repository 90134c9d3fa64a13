// Tests overriding options for vals, attributes and parameters.

#include "netlist/print/print.hpp"
#include "netlist/read.hpp"
#include "tests/netlist/good_networks.hpp"
#include "tests/netlist/small_catalogue.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace placedpar;

namespace {

/// A master and two slaves on processors of their own; one wire has a name and a speed, the other wire has neither.
const std::string cluster = R"(val people 30; val code "binary"; val times 2;
T800 (memory = 1M) root, t[2];
connection (linkspeed = 20M) c;
connect root.link[0] to t[0].link[0] by c;
connect root.link[1] to t[1].link[0];
process m, s[2];
process (interface (input in, output out, char label[20] = "none", int size[2] = {1, 2})) other;
use "ga.master" for m;
use "ga.slave" for s;
use "other.lku" for other;
m (population = people, code = code);
s (cycles = 5);
connect m.out to s[0].in;
connect s[0].out to m.back;
connect s[1].out to other.in;
connect other.out to s[1].in;
place m on root;
place s[0] on t[0];
place s[1] on t[1];
place other on t[1];
)";

/// Returns the message about the cluster with these overrides. The kinds of `other` and s[1] do not fit, but overrides
/// are refused earlier. A cluster parsed once for all tests must be refused like a newly parsed cluster.
std::string refusal(const Overrides& overrides) {
    static const ParsedNetlist parsed = ParsedNetlist::of_text(cluster);
    std::string said = render(parsed.read(small_catalogue(), overrides));
    CHECK(said == render(read_netlist_text(cluster, small_catalogue(), overrides)));
    return said;
}

/// The cluster without process s[1] and with a kind for `other`, so that it can run.
const std::string sound = R"(val people 30; val code "binary"; val times 2;
T800 (memory = 1M) root, t[2];
connection (linkspeed = 20M) c;
connect root.link[0] to t[0].link[0] by c;
connect root.link[1] to t[1].link[0];
process m, s;
process (interface (char label[20] = "none", int size[2] = {1, 2})) other;
use "ga.master" for m;
use "ga.slave" for s;
use "other.lku" for other;
m (population = people, code = code);
s (cycles = 5);
connect m.out to s.in;
connect s.out to m.back;
place m on root;
place s on t[0];
place other on t[1];
)";

const ProcessInstance& process(const Network& network, const std::string& name) {
    return *std::ranges::find(network.processes, name, &ProcessInstance::name);
}

std::vector<std::int64_t> speeds(const Network& network) {
    std::vector<std::int64_t> found;
    for (const Node& node : network.nodes)
        found.push_back(node.integer("linkspeed"));
    for (const LinkConnection& connection : network.connections)
        found.push_back(connection.bits_per_second);
    return found;
}

using Elements = std::vector<std::string>;

bool says(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

} // namespace

TEST_CASE("--set with a plain name sets a val, or an attribute or parameter of every element that has it") {
    constexpr std::int64_t slow = 10'000'000;
    auto network = good_text(sound, {{"linkspeed", "10M"}});
    CHECK(speeds(network) == std::vector(5, slow));
    REQUIRE(network.set.size() == 1);
    CHECK(network.set[0].name == "linkspeed");
    CHECK(network.set[0].value == "10M");
    CHECK(network.set[0].elements == Elements{"root", "t[0]", "t[1]", "c"});

    CHECK(process(good_text(sound, {{"cycles", "times * 7"}}), "s").parameters.at("cycles") == Value(std::int64_t{14}));
    auto val = good_text("val clock 1M; T800 (memory = clock) t;", {{"clock", "3M"}}); // sets the val
    CHECK(val.nodes[0].integer("memory") == 3 * 1024 * 1024);
    CHECK(val.nodes[0].integer("clock") == 20'000'000);
    CHECK(val.set[0].elements.empty());
}

TEST_CASE("--set with a name sets one element or all elements of an array") {
    CHECK(process(good_text(sound, {{"m.mutation", "0.5"}}), "m").parameters.at("mutation") == Value(0.5));
    auto one = good_text(sound, {{"t[1].clock", "25M"}});
    CHECK(one.nodes[1].integer("clock") == 20'000'000);
    CHECK(one.nodes[2].integer("clock") == 25'000'000);
    CHECK(one.set[0].elements == Elements{"t[1]"});
    auto all = good_text(sound, {{"t.memory", "2M"}, {"t[times - 1].clock", "25M"}});
    CHECK(all.nodes[1].integer("memory") == 2 * 1024 * 1024);
    CHECK(all.nodes[2].integer("memory") == 2 * 1024 * 1024);
    CHECK(all.nodes[2].integer("clock") == 25'000'000);
    CHECK(good_text(sound, {{"c.length", "3"}}).connections[0].metres == 3);
    CHECK(process(good_text(sound, {{"m.priority", "HIGH"}}), "m").high_priority);
    CHECK_FALSE(process(good_text(sound, {{"m.priority", "HIGH"}}), "s").high_priority);
    CHECK(process(good_text(sound, {{"m.stacksize", "4k"}}), "m").other.at("stacksize") == Value(std::int64_t{4096}));
}

TEST_CASE("--set length sets the length of every wire, named or not, and the printed network loads again") {
    auto network = good_text(sound, {{"length", "10"}});
    for (const LinkConnection& connection : network.connections)
        CHECK(connection.metres == 10);
    CHECK(good_text(print_cfs(network)).hash == network.hash);
}

TEST_CASE("--set sets parameters that the netlist leaves out, with and without a default") {
    std::string text = "T800 t; process m, s; use \"ga.master\" for m; use \"ga.slave\" for s; connect m.out to s.in; "
                       "connect s.out to m.back; place m on t; place s on t;";
    CHECK_FALSE(read_netlist_text(text, small_catalogue()).network);
    CHECK(process(good_text(text, {{"m.population", "8"}}), "m").parameters.at("population") == Value(std::int64_t{8}));
}

TEST_CASE("--set takes strings without quotes") {
    auto code = [](const Overrides& overrides) {
        return process(good_text(sound, overrides), "m").parameters.at("code");
    };
    for (const char* name : {"code", "m.code"})
        for (const char* value : {"gray", "\"gray\"", " gray "})
            CHECK(code({{name, value}}) == Value("gray"));
    auto label = [](const char* value) {
        return process(good_text(sound, {{"other.label", value}}), "other").parameters.at("label");
    };
    CHECK(label("a-b/c d.csv") == Value("a-b/c d.csv"));
    CHECK(label("5") == Value("5"));
    CHECK(label("people") == Value("people")); // this val is not a string
    CHECK(label("code") == Value("binary"));   // this val is a string
    CHECK(label("") == Value(""));
    CHECK(says(refusal({{"other.label", "\"a"}}), "--set:1:13: error: the string does not end"));
    CHECK(says(refusal({{"m.population", "many"}}), "--set:1:14: error: the name \"many\" is undefined"));
}

TEST_CASE("values of --set are checked like values in the netlist, with errors at the option") {
    CHECK(says(refusal({{"m.mutation", "2"}}), "--set:1:12: error: the parameter \"mutation\" is out of range: 2\n"
                                               "    m.mutation=2\n"
                                               "               ^\n"
                                               "hint: expected from 0 to 1\n"));
    CHECK(says(refusal({{"m.code", "grey"}}), "--set:1:8: error: illegal value of the parameter \"code\": \"grey\""));
    CHECK(says(refusal({{"m.code", "grey"}}), "did you mean \"gray\"?"));
    CHECK(says(refusal({{"m.population", "\"x\""}}), "--set:1:14: error: wrong type for the parameter"));
    CHECK(says(refusal({{"linkspeed", "-1"}}), "--set:1:11: error: illegal value of the attribute \"linkspeed\": -1"));
    CHECK(says(refusal({{"linkspeed", "2G"}}), "--set:1:11: error: \"2G\" is not a number"));
    CHECK(says(refusal({{"people", "3x"}}), "--set:1:8: error: \"3x\" is not a number"));
    CHECK(says(refusal({{"c.length", "\"x\""}}), "--set:1:10: error: wrong type for the attribute \"length\""));
    CHECK(says(refusal({{"m.priority", "2"}}), "expected HIGH (0) or LOW (1)"));
    CHECK(says(refusal({{"people", "1.5"}}), "--set:1:8: error: wrong type for the val \"people\""));
    CHECK(says(refusal({{"other.label", "123456789012345678901"}}), "--set:1:13: error: the string is too long"));
    CHECK(says(refusal({{"other.size", "{1, 2, 3}"}}), "--set:1:12: error: wrong type for the parameter \"size\""));
    CHECK(says(refusal({{"other.size[1]", "3"}}), "\"size\" can be set only as a whole"));
}

TEST_CASE("setting a value twice is refused") {
    CHECK(says(refusal({{"s[1].cycles", "1"}, {"s[times - 1].cycles", "2"}}), "\"cycles\" of \"s[1]\" is set twice\n"));
    CHECK(says(refusal({{"s.cycles", "1"}, {"s .cycles", "2"}}), "note: set first here\n"));
    CHECK(says(refusal({{"people", "1"}, {" people", "2"}}), "the val \"people\" is set twice\n"));
    CHECK(says(refusal({{"m.mutation", "1"}, {"m . mutation", "1"}}), "\"mutation\" of \"m\" is set twice\n"));
}

TEST_CASE("a setting of an element overrides a setting of its array, which overrides a setting of all elements") {
    Overrides overrides{{"clock", "5M"}, {"t.clock", "10M"}, {"t[1].clock", "25M"}};
    auto network = good_text(sound, overrides);
    std::vector<std::int64_t> clocks;
    for (const Node& node : network.nodes)
        clocks.push_back(node.integer("clock"));
    CHECK(clocks == std::vector<std::int64_t>{5'000'000, 10'000'000, 25'000'000});
    std::vector<Elements> reached;
    for (const SetByOption& each : network.set)
        reached.push_back(each.elements);
    CHECK(reached == std::vector<Elements>{{"root"}, {"t[0]"}, {"t[1]"}});
    auto none_left = good_text(sound, {{"cycles", "5"}, {"s.cycles", "6"}});
    CHECK(process(none_left, "s").parameters.at("cycles") == Value(std::int64_t{6}));
    CHECK(none_left.set.size() == 1);
}

TEST_CASE("--set accepts a wire without a name by its name in reports") {
    auto network = good_text(sound, {{"wire[0].length", "10"}});
    CHECK(network.connections[0].metres == 0); // c
    CHECK(network.connections[1].metres == 10);
    CHECK(good_text(sound, {{"c.length", "1"}}).connections[1].name.empty());
    CHECK(says(refusal({{"lenght", "10"}}), "did you mean \"length\"?"));
    CHECK(says(refusal({{"lenght", "10"}}), "note: connections and their attributes: c, wire (linkspeed, length)\n"));
}

namespace {

/// Two bus masters and an adapter. One of the masters is attached by a named connection.
const std::string on_bus =
    R"(VME vme; busmaster a, b; C012 (master = "a") adapter; T800 t; connection at_a, cable, spare;
connect a.bus[0] to vme.slot[1] by at_a;
connect b.bus[0] to vme.slot[2];
connect adapter.bus[0] to vme.slot[3] by spare;
connect adapter.link[0] to t.link[0] by cable;
)";

struct PlaceOnBus {
    int level;
    bool on_request;
    bool operator==(const PlaceOnBus&) const = default;
};

/// Returns the bus attachments of a and b.
std::vector<PlaceOnBus> places_on_bus(const Overrides& overrides) {
    std::vector<PlaceOnBus> found;
    for (const BusAttachment& each : good_text(on_bus, overrides).attachments)
        if (each.slot < 3)
            found.push_back({each.level, each.on_request});
    return found;
}

} // namespace

TEST_CASE("--set sets level and release of one master on a bus or of all masters") {
    using Places = std::vector<PlaceOnBus>;
    CHECK(places_on_bus({}) == Places{{3, false}, {3, false}});
    CHECK(places_on_bus({{"at_a.level", "1"}, {"at_a.release", "ROR"}}) == Places{{1, true}, {3, false}});
    CHECK(places_on_bus({{"attachment[0].level", "0"}}) == Places{{3, false}, {0, false}});
    CHECK(places_on_bus({{"release", "ROR"}, {"level", "2"}, {"at_a.level", "3"}}) == Places{{3, true}, {2, true}});
    CHECK(good_text(on_bus, {{"vme.arbiter", "RRS"}}).hash == good_text(on_bus, {{"vme.arbiter", "\"RRS\""}}).hash);
    Network network = good_text(on_bus, {{"release", "\"ROR\""}});
    CHECK(network.set[0].elements == Elements{"at_a", "attachment[0]"});
    CHECK(good_text(print_cfs(network)).hash == network.hash);
    CHECK(good_text(on_bus, {{"length", "2"}}).set[0].elements == Elements{"cable"}); // the attachments are not set
}

TEST_CASE("wrong attributes and values of a master's place on a bus are refused") {
    auto told = [](const char* name, const char* value) {
        return render(read_netlist_text(on_bus, small_catalogue(), {{name, value}}));
    };
    CHECK(says(told("at_a.length", "1"), "--set:1:6: error: the connection \"at_a\" has no attribute \"length\"\n"));
    CHECK(says(told("at_a.length", "1"), "note: it has level, release\n"));
    CHECK(says(told("cable.level", "1"), "note: it has linkspeed, length\n"));
    CHECK(says(told("spare.level", "1"), "note: it has nothing that can be set\n"));
    CHECK(says(told("at_a.level", "4"), "illegal value of the attribute \"level\": 4\n"));
    CHECK(says(told("at_a.level", "top"), "hint: expected an integer from 0 to 3\n"));
    CHECK(says(told("a.level", "1"),
               "hint: the connection of \"a\" to its bus has this attribute: --set at_a.level=...\n"));
    CHECK(says(told("b.release", "ROR"),
               "hint: the connection of \"b\" to its bus has this attribute: --set attachment[0].release=...\n"));
    CHECK(!says(told("t.release", "ROR"), "hint: "));
    CHECK(says(told("release", "ROAK"), "hint: expected one of RWD, ROR\n"));
    CHECK(says(told("relase", "ROR"), "hint: did you mean \"release\"?\n"));
    CHECK(says(told("vme.arbiter", "SQL"), "hint: expected one of PRI, RRS, SGL\n"));
    CHECK(says(told("relase", "ROR"), "at_a, attachment (level, release)"));
}

TEST_CASE("the message about a wrong setting shows the right form") {
    auto told = [](const std::string& text, const Overrides& overrides) {
        return render(read_netlist_text(text, small_catalogue(), overrides));
    };
    const std::string vals = "val numbers {1, 2, 3}; val b 5; val ch 'x'; T800 a; T800 t[2];";
    auto said = [&](const char* name, const char* value) { return told(vals, {{name, value}}); };
    CHECK(
        says(said("numbers[0]", "4"), "1:1: error: the val \"numbers\" can be set only as a whole, not by element\n"));
    CHECK(says(said("numbers[0]", "4"), "hint: in the netlist its value is {1, 2, 3}: --set 'numbers=...'\n"));
    CHECK(says(said("b[0]", "4"), "1:1: error: the val \"b\" is not an array\n"));
    CHECK(says(said("numbers", "4"), "wrong type for the val \"numbers\": 4 is an integer\n"));
    CHECK(says(said("numbers", "4"), "hint: in the netlist its value is {1, 2, 3}, an array\n"));
    CHECK(says(said("b", "{1,2}"), "wrong type for the val \"b\": {1, 2} is an array\n"));
    CHECK(says(said("a.", "3"), "the name of an attribute or a parameter is missing: found \"=\"\n"));
    CHECK(says(said("ch", "q"), "the name \"q\" is undefined\n"));
    CHECK(says(said("ch", "q"), "hint: in the netlist its value is 120, an integer; a character is written 'c'\n"));
    CHECK(says(said("linkspeed", "fast"), "hint: expected an integer from 1 to 1000000000 bit/s\n"));
    CHECK_FALSE(says(said("linkspeed", "fast"), "FALSE"));
    CHECK(says(said("linkspeed", "numbrs"), "did you mean \"numbers\"?"));
    CHECK(says(said("a[1].clock", "3"), "1:1: error: \"a\" is not an array\n"));
    CHECK(says(said("t[1]", "3"), "1:1: error: \"t\" is a node: name the attribute or parameter to set\n"));
    CHECK(says(said("t[1]", "3"), "hint: --set t[1].NAME=VALUE\n"));
    CHECK(says(refusal({{"m.priority", "hihg"}}), "hint: expected HIGH or LOW\n"));
    CHECK(says(refusal({{"seed", "3"}}), "hint: set the seed of a run with the option --seed N\n"));
    CHECK(says(told("val long {1000000000, 2000000000, 3000000000, 4, 5};", {{"long", "4"}}),
               "{1000000000, 2000000000, 3000000000, ...}"));
}

TEST_CASE("the message about an unknown name gives the nearest name or all names") {
    auto unknown = refusal({{"peeple", "3"}});
    CHECK(unknown == "--set:1:1: error: the netlist has no val, attribute or parameter \"peeple\"\n"
                     "    peeple=3\n"
                     "    ^\n"
                     "hint: did you mean \"people\"?\n"
                     "note: vals: people = 30, code = \"binary\", times = 2\n"
                     "note: processes and their parameters: m (population, mutation, code, priority), s (cycles, "
                     "priority), other (label, size, priority)\n"
                     "note: nodes and their attributes: root, t (memory, clock, linkspeed, channelcall, "
                     "memorycycles, switching, hosttime, wraps, routecost, linkquota, router_priority, router_cycles)\n"
                     "note: connections and their attributes: c, wire (linkspeed, length)\n");
    CHECK(says(refusal({{"m.mutatoin", "3"}}), "--set:1:3: error: the process \"m\" has no parameter \"mutatoin\"\n"
                                               "    m.mutatoin=3\n"
                                               "      ^\n"
                                               "hint: did you mean \"mutation\"?\n"
                                               "note: it has population, mutation, code, priority\n"));
    CHECK(says(refusal({{"rot.clock", "3"}}), "no node, connection or process \"rot\"\n"));
    CHECK(says(refusal({{"rot.clock", "3"}}), "hint: did you mean \"root\"?\n"));
    // "people" is a similar name, but the name of a val.
    CHECK_FALSE(says(refusal({{"peoples.clock", "3"}}), "did you mean"));
    CHECK(says(refusal({{"t[2].clock", "3"}}), "nothing has the name \"t[2]\"\n    t[2].clock=3\n    ^\n"
                                               "hint: the names are t[0] to t[1]\n"));
    CHECK(
        says(refusal({{"s[1].clock", "3"}}), "hint: the node of \"s[1]\" has this attribute: --set t[1].clock=...\n"));
    CHECK(says(refusal({{"m", "3"}}), "\"m\" is a process: name the attribute or parameter to set\n"));
    CHECK(says(refusal({{"clok", "3"}}), "hint: did you mean \"clock\"?\n"));
    std::string many;
    for (int i = 0; i < 100; ++i)
        many += "val v" + std::to_string(i) + " 1; T800 t" + std::to_string(i) + ";\n";
    auto listed = render(read_netlist_text(many, small_catalogue(), {{"nothing_like_it", "1"}}));
    CHECK(says(listed, "note: vals: v0 = 1, v1 = 1,"));
    CHECK(says(listed, " and 88 more\n"));
    CHECK_FALSE(says(listed, "v20"));
    CHECK_FALSE(says(listed, "t20"));
}
