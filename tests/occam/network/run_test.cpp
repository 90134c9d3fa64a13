// Runs netlists whose processes are in occam.

#include "netlist/kinds/description.hpp"
#include "netlist/kinds/environment.hpp"
#include "netlist/print/print.hpp"
#include "tests/occam/network/network_text.hpp"

#include <doctest/doctest.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

using namespace placedpar;

namespace {

const std::string examples = std::string(PLACEDPAR_SOURCE_DIR) + "/examples/occam/network/";

/// Outputs count numbers, and -1.
constexpr const char* source = R"(
PROC source (VAL INT count, CHAN OF INT out)
  SEQ
    SEQ i = 0 FOR count
      out ! (i * i) REM 1001
    out ! -1
:
)";
/// Adds a number to each number.
constexpr const char* relay = R"(
PROC relay (VAL INT more, CHAN OF INT in, out)
  INT x:
  SEQ
    x := 0
    WHILE x >= 0
      SEQ
        in ? x
        IF
          x < 0
            SKIP
          TRUE
            x := (x PLUS more) /\ #FFFF
        out ! x
:
)";
/// Prints the sum of all numbers.
constexpr const char* sink = R"(
#INCLUDE "hostio.inc"
#USE "hostio.lib"
PROC sink (CHAN OF SP fs, ts, CHAN OF INT in)
  INT x, sum:
  SEQ
    x := 0
    sum := 0
    WHILE x >= 0
      SEQ
        in ? x
        IF
          x < 0
            SKIP
          TRUE
            sum := (sum TIMES 31) PLUS x
    so.write.int (fs, ts, sum, 0)
    so.exit (fs, ts, sps.success)
:
)";

/// Returns what a chain of relays prints, by the same arithmetic in C++.
std::string sum_behind(std::int32_t count, const std::vector<std::int32_t>& more) {
    std::uint32_t sum = 0;
    for (std::int32_t i = 0; i < count; ++i) {
        std::int32_t x = (i * i) % 1001;
        for (const std::int32_t each : more)
            x = static_cast<std::int32_t>(static_cast<std::uint32_t>(x) + static_cast<std::uint32_t>(each)) & 0xffff;
        sum = sum * 31 + static_cast<std::uint32_t>(x);
    }
    return std::to_string(static_cast<std::int32_t>(sum));
}

/// Adds the kinds NAME.out, which outputs the messages, and NAME.in, which measures how many of them come back.
template <class T>
void add_both_ends(Catalogue& catalogue, const std::string& name, const std::vector<T>& messages) {
    catalogue.add({.name = name + ".out",
                   .about = "",
                   .ports = {description::output<T>("out", name, "")},
                   .body = [messages](ProcessEnvironment& self) {
                       for (const T& each : messages)
                           self.output<T>("out").output(each);
                   }});
    catalogue.add({.name = name + ".in",
                   .about = "",
                   .ports = {description::input<T>("in", name, "")},
                   .measurements = {{"equal", "", ""}},
                   .body = [messages](ProcessEnvironment& self) {
                       double equal = 0;
                       for (const T& each : messages)
                           equal += self.input<T>("in").input() == each;
                       self.measure("equal", equal);
                   }});
}

/// A PROC that hands values of a type on.
std::string hands_on(const std::string& protocol, const std::string& variables, const std::string& item) {
    return fmt::format("PROC hand.on (CHAN OF {0} in, out)\n  {1}:\n  WHILE TRUE\n    SEQ\n      in ? {2}\n      out ! "
                       "{2}\n:\n",
                       protocol, variables, item);
}

double equal_behind_occam(const std::string& name, const Catalogue& catalogue, const std::string& occam) {
    const test::FilesOfNetwork files({{"on.occ", occam},
                                      {"on.cfs", fmt::format(R"(
T800 (memory = 1M) left, middle, right;
connect left.link[0] to middle.link[3];
connect right.link[1] to middle.link[2];
process a, b, relay;
use "{0}.out" for a; use "{0}.in" for b; use "on.occ" for relay;
place a on left; place relay on middle; place b on right;
connect a.out to relay.in;
connect relay.out to b.in;
)",
                                                             name)}});
    return test::run_network(files.path("on.cfs"), catalogue).report.measured("b", "equal");
}

} // namespace

TEST_CASE("the philosophers of a netlist share a transputer, or have one each") {
    const Catalogue catalogue = test::occam_catalogue();
    const std::string meals = "philosopher 0 ate 3 times\nphilosopher 1 ate 3 times\nphilosopher 2 ate 3 times\n"
                              "philosopher 3 ate 3 times\nphilosopher 4 ate 3 times\n";
    std::string shared = test::run_network(examples + "table.cfs", catalogue).screen;
    std::erase(shared, '\r');
    CHECK(shared == meals);
    const test::RunOfNetwork again = test::run_network(examples + "table.cfs", catalogue);
    CHECK(again.report.result.fingerprint ==
          test::run_network(examples + "table.cfs", catalogue).report.result.fingerprint);
    const auto spread = test::run_network(examples + "spread.cfs", catalogue);
    CHECK(spread.report.programs.size() == 3);
    std::string on_screen = spread.screen;
    std::erase(on_screen, '\r');
    CHECK(on_screen == meals);
}

TEST_CASE("chains of relays, placed at random, compute what C++ computes") {
    const Catalogue catalogue = test::occam_catalogue();
    std::mt19937 random(7);
    const auto draw = [&](int least, int most) {
        return least + static_cast<int>(random() % static_cast<unsigned>(most - least + 1));
    };
    const std::vector<std::string> types = {"T414", "T425", "T800", "T805"};
    for (int round = 0; round < 12; ++round) {
        const int nodes = draw(1, 5), relays = draw(nodes, 12), count = draw(0, 40);
        std::string text;
        for (int i = 0; i < nodes; ++i)
            text += fmt::format("{} (memory = 256K) n{};\n", types[static_cast<std::size_t>(draw(0, 3))], i);
        for (int i = 0; i + 1 < nodes; ++i)
            text += fmt::format("connect n{}.link[{}] to n{}.link[{}];\n", i, 2, i + 1, draw(0, 1));
        text += fmt::format("connect n{}.link[3] to host;\nprocess source, relay[{}], sink;\n", nodes - 1, relays);
        text += "use \"source.occ\" for source; use \"relay.occ\" for relay; use \"sink.occ\" for sink;\n";
        text += fmt::format("source (count = {}); place source on n0; place sink on n{};\n", count, nodes - 1);
        text += "connect source.out to relay[0].in;\n";
        std::vector<std::int32_t> more;
        for (int i = 0, node = 0; i < relays; ++i) {
            // the way leads to the last node, one node at a time
            const int left = relays - i;
            if (node + 1 < nodes && (draw(0, 1) == 1 || left <= nodes - 1 - node))
                ++node;
            more.push_back(draw(-100, 70000));
            text += fmt::format(
                "relay[{0}] (more = {1}{2}); place relay[{0}] on n{3};\nconnect relay[{0}].out to {4}.in;\n", i,
                more.back(), draw(0, 3) == 0 ? ", priority = HIGH" : "", node,
                i + 1 < relays ? fmt::format("relay[{}]", i + 1) : "sink");
        }
        CAPTURE(text);
        const test::FilesOfNetwork files(
            {{"source.occ", source}, {"relay.occ", relay}, {"sink.occ", sink}, {"chain.cfs", text}});
        CHECK(test::run_network(files.path("chain.cfs"), catalogue).screen == sum_behind(count, more));
    }
}

TEST_CASE("occam and C++ exchange messages of each type over links") {
    Catalogue catalogue = test::occam_catalogue();
    add_both_ends<std::int32_t>(catalogue, "int", {-1, 7, 0x12345678});
    add_both_ends<std::uint8_t>(catalogue, "byte", {0, 255, 3});
    add_both_ends<bool>(catalogue, "bool", {true, false, true});
    add_both_ends<std::int16_t>(catalogue, "int16", {-32768, 5, 32767});
    add_both_ends<std::int64_t>(catalogue, "int64", {-1, 1LL << 60, 4});
    add_both_ends<float>(catalogue, "real32", {1.5F, -2.25e20F, 0.1F});
    add_both_ends<double>(catalogue, "real64", {1.5, -2.25e200, 0.1});
    add_both_ends<std::vector<std::uint8_t>>(catalogue, "bytes", {{1, 2, 3}, {}, {255}});
    add_both_ends<std::vector<std::int32_t>>(catalogue, "ints", {{1, -2}, {}, {7, 8, 9, 10}});
    const auto equal = [&](const std::string& name, const std::string& occam) {
        return equal_behind_occam(name, catalogue, occam);
    };
    CHECK(equal("int", hands_on("INT", "INT x", "x")) == 3);
    CHECK(equal("int", hands_on("INT32", "INT32 x", "x")) == 3);
    CHECK(equal("byte", hands_on("BYTE", "BYTE x", "x")) == 3);
    CHECK(equal("bool", hands_on("BOOL", "BOOL x", "x")) == 3);
    CHECK(equal("int16", hands_on("INT16", "INT16 x", "x")) == 3);
    CHECK(equal("int64", hands_on("INT64", "INT64 x", "x")) == 3);
    CHECK(equal("real32", hands_on("REAL32", "REAL32 x", "x")) == 3);
    CHECK(equal("real64", hands_on("REAL64", "REAL64 x", "x")) == 3);
    CHECK(equal("bytes", hands_on("INT::[]BYTE", "INT n:\n  [10]BYTE x", "n::x")) == 3);
    CHECK(equal("ints", hands_on("INT::[]INT", "INT n:\n  [10]INT x", "n::x")) == 3);
}

TEST_CASE("a producer and a consumer in C++ have a filter in occam between them") {
    const auto run = test::run_network(examples + "mixed.cfs", test::occam_catalogue());
    CHECK(run.report.measured("consumer", "last_number") == 81);
}

TEST_CASE("a process gets the values of its parameters") {
    constexpr const char* parameters = R"(
#INCLUDE "hostio.inc"
#USE "hostio.lib"
PROC show (CHAN OF SP fs, ts, VAL INT i, VAL BYTE b, VAL BOOL yes, VAL INT64 l, VAL REAL32 r, VAL REAL64 d, VAL []BYTE a.text)
  SEQ
    so.write.int (fs, ts, i, 0)
    so.write.char (fs, ts, ' ')
    so.write.int (fs, ts, INT b, 0)
    IF
      yes
        so.write.string (fs, ts, " yes ")
      TRUE
        so.write.string (fs, ts, " no ")
    so.write.int64 (fs, ts, l, 0)
    so.write.char (fs, ts, ' ')
    so.write.real32 (fs, ts, r, 0, 0)
    so.write.char (fs, ts, ' ')
    so.write.real64 (fs, ts, d, 0, 0)
    so.write.string (fs, ts, a.text)
    so.exit (fs, ts, sps.success)
:
)";
    const test::FilesOfNetwork files({{"show.occ", parameters}, {"show.cfs", R"(
process show;
use "show.occ" for show;
show (i = 0 - 2147483648, b = 255, yes = 1, l = 0 - 5, r = 1.5, d = -0.1, a_text = " it's *5 \"x\"");
)"}});
    const Catalogue catalogue = test::occam_catalogue();
    CHECK(test::run_network(files.path("show.cfs"), catalogue).screen ==
          "-2147483648 255 yes -5 1.5 -0.10000000000000001 it's *5 \"x\"");
    CHECK(test::run_network(files.path("show.cfs"), catalogue, {{"show.i", "7"}, {"show.yes", "0"}}).screen ==
          "7 255 no -5 1.5 -0.10000000000000001 it's *5 \"x\"");
}

TEST_CASE("a process with keyboard, screen and error has the terminal of its host") {
    const test::FilesOfNetwork files(
        {{"hello.occ", R"(
PROC hello (VAL INT times, CHAN BYTE keyboard?, screen!, error!)
  VAL text IS "hello*n":
  SEQ i = 0 FOR times
    SEQ j = 0 FOR SIZE text
      screen ! text[j]
:
)"},
         {"hello.cfs", "process hello; use \"hello.occ\" for hello; hello (times = 2);\n"}});
    const auto run = test::run_network(files.path("hello.cfs"), test::occam_catalogue());
    std::string screen = run.screen;
    std::erase(screen, '\r');
    CHECK(screen == "hello\nhello\n");
    CHECK(run.report.programs.front().state == "exited with success");
}

TEST_CASE("a run without a host lasts until the programs end, or are in a deadlock") {
    const std::string netlist = "T800 (memory = 64K) a, b; connect a.link[0] to b.link[0];\n"
                                "process source, relay, end; use \"source.occ\" for source;\n"
                                "use \"relay.occ\" for relay; use \"end.occ\" for end;\n"
                                "source (count = 9); relay (more = 1); end (count = COUNT);\n"
                                "place source on a; place relay on b; place end on b;\n"
                                "connect source.out to relay.in; connect relay.out to end.in;\n";
    constexpr const char* end =
        "PROC end (VAL INT count, CHAN OF INT in)\n  INT x:\n  SEQ i = 0 FOR count\n    in ? x\n:\n";
    const auto run = [&](const std::string& count) {
        std::string text = netlist;
        text.replace(text.find("COUNT"), 5, count);
        const test::FilesOfNetwork files(
            {{"source.occ", source}, {"relay.occ", relay}, {"end.occ", end}, {"a.cfs", text}});
        return test::run_network(files.path("a.cfs"), test::occam_catalogue()).report;
    };
    const RunReport whole = run("10");
    CHECK(whole.result.ending == Ending::completed);
    CHECK(whole.result.time > Time{0});
    for (const char* count : {"9", "11"}) {
        const RunReport stuck = run(count);
        CHECK(stuck.result.ending == Ending::stuck);
        REQUIRE(stuck.result.deadlock);
        std::vector<std::string> paths;
        for (const StuckProcess& process : stuck.result.deadlock->processes)
            paths.push_back(process.path);
        CHECK(std::ranges::count(paths, "the code of b") == 1);
        CHECK(std::ranges::count(paths, "the code of a") == 0);
        CHECK(std::ranges::count(paths, count == std::string("9") ? "relay" : "end") == 1);
    }
}

TEST_CASE("arrays of channels are port arrays, also at both ends of a channel") {
    constexpr const char* deal = R"(
PROC deal (VAL INT count, [3]CHAN OF INT out)
  SEQ i = 0 FOR count
    PAR j = 0 FOR 3
      out[j] ! (10 * i) + j
:
PROC collect (VAL INT count, []CHAN OF INT in, CHAN OF INT out)
  SEQ
    SEQ i = 0 FOR count
      SEQ j = 0 FOR SIZE in
        INT x:
        SEQ
          in[j] ? x
          out ! x
    out ! -1
:
)";
    const std::string netlist = R"(
T800 (memory = 64K) a; T800 (memory = 64K) b;
connect a.link[0] to b.link[0];
connect a.link[1] to b.link[1];
connect a.link[2] to b.link[2];
connect b.link[3] to host;
process deal, collect, sink;
use "deal.occ#deal" for deal; use "deal.occ" for collect; use "sink.occ" for sink;
deal (count = 5); collect (count = 5);
place deal on a; place collect on WHERE; place sink on b;
connect deal.out[0] to collect.in[2];
connect deal.out[1] to collect.in[0];
connect deal.out[2] to collect.in[1];
connect collect.out to sink.in;
)";
    std::uint32_t sum = 0;
    for (std::uint32_t i = 0; i < 5; ++i)
        for (const std::uint32_t j : {1U, 2U, 0U})
            sum = sum * 31 + 10 * i + j;
    for (const std::string where : {"a", "b"}) {
        std::string text = netlist;
        text.replace(text.find("WHERE"), 5, where);
        const test::FilesOfNetwork files({{"deal.occ", deal}, {"sink.occ", sink}, {"deal.cfs", text}});
        CHECK(test::run_network(files.path("deal.cfs"), test::occam_catalogue()).screen == std::to_string(sum));
    }
}

TEST_CASE("the hash of a network depends on the text of its files, and on what these include") {
    const test::FilesOfNetwork files(
        {{"source.occ", "#INCLUDE \"more.inc\"\n" + std::string(source)},
         {"more.inc", "VAL more IS 1:\n"},
         {"sink.occ", sink},
         {"a.cfs", "process source, sink; use \"source.occ\" for source; use \"sink.occ\" for sink;\n"
                   "source (count = 3); connect source.out to sink.in;\n"}});
    const Catalogue catalogue = test::occam_catalogue();
    const auto hash = [&] { return read_netlist(files.path("a.cfs"), catalogue).network.value().hash; };
    const std::uint64_t first = hash();
    CHECK(hash() == first);
    files.write("more.inc", "VAL more IS 2:\n");
    const std::uint64_t second = hash();
    CHECK(second != first);
    files.write("source.occ", "-- more\n#INCLUDE \"more.inc\"\n" + std::string(source));
    CHECK(hash() != second);
}

TEST_CASE("a program is compiled once for all runs of a study that have the same processes on its node") {
    const test::FilesOfNetwork files({{"source.occ", source}, {"sink.occ", sink}, {"two.cfs", R"(
val speed 20M;
val more 5;
T800 (memory = 256K, linkspeed = speed) a, b;
connect a.link[2] to b.link[1];
connect b.link[3] to host;
process source, sink;
use "source.occ" for source; use "sink.occ" for sink;
source (count = more);
place source on a; place sink on b;
connect source.out to sink.in;
)"}});
    const Catalogue catalogue = test::occam_catalogue();
    std::set<std::shared_ptr<const transputer::Image>> of_a, of_b;
    const auto run = [&](const Overrides& overrides) {
        const ReadResult read = read_netlist(files.path("two.cfs"), catalogue, overrides);
        INFO(render(read));
        REQUIRE(read.network);
        of_a.insert(read.network->nodes[0].image);
        of_b.insert(read.network->nodes[1].image);
    };
    for (int i = 0; i < 50; ++i)
        run({{"speed", i % 2 == 0 ? "20M" : "5M"}});
    CHECK(of_a.size() == 1);
    for (int i = 0; i < 50; ++i)
        run({{"more", std::to_string(i % 10)}});
    CHECK(of_a.size() == 10); // more = 5 is one of them
    CHECK(of_b.size() == 1);
    files.write("sink.occ", std::string(sink) + "-- changed\n");
    run({});
    CHECK(of_a.size() == 10);
    CHECK(of_b.size() == 2);
}

TEST_CASE("a printed network can be read again, and is the same") {
    const Catalogue catalogue = test::occam_catalogue();
    for (const char* name : {"table.cfs", "spread.cfs", "mixed.cfs", "../routed/farm.cfs"}) {
        const Network network = read_netlist(examples + name, catalogue).network.value();
        const std::string printed = print_cfs(network);
        const ReadResult again = read_netlist_text(printed, catalogue);
        INFO(printed, render(again));
        REQUIRE(again.network);
        CHECK(again.network->hash == network.hash);
        CHECK(print_cfs(*again.network) == printed);
    }
}
