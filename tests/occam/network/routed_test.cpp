// Tests channels of occam that share wires, or lead over other processors.

#include "netlist/machine.hpp"
#include "tests/occam/network/network_text.hpp"
#include "tests/occam/network/random_traffic.hpp"
#include "tests/seeds.hpp"

#include <doctest/doctest.h>

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

using namespace placedpar;

namespace {

/// Outputs numbers to two channels, and inputs an answer to each pair.
constexpr const char* pair_of_channels = R"(
PROC give (VAL INT count, CHAN OF INT a, b, back)
  INT x:
  SEQ i = 0 FOR count
    SEQ
      a ! i
      b ! i + 1
      back ? x
:
PROC take (VAL INT count, CHAN OF INT a, b, back)
  INT x, y:
  SEQ i = 0 FOR count
    SEQ
      a ? x
      b ? y
      ASSERT (y = (x + 1))
      back ! y
:
)";

/// Two processes of pair_of_channels on a chain of three transputers.
std::string chain(int given, int taken, const std::string& more = "") {
    return fmt::format(R"(
T800 (memory = 64K) a, m, b;
connect a.link[0] to m.link[1];
connect m.link[0] to b.link[1];
process p, q;
use "pair.occ#give" for p; use "pair.occ#take" for q;
p (count = {}); q (count = {});
place p on a; place q on b;
connect p.a to q.a; connect p.b to q.b; connect q.back to p.back;
{})",
                       given, taken, more);
}

/// Prints the sum of what comes from all processes of a grid, each of which sends a number to each other one at once.
constexpr const char* all_to_all = R"(
#INCLUDE "hostio.inc"
#USE "hostio.lib"
PROC cell (VAL INT number, rounds, [8]CHAN OF INT in, out, CHAN OF INT result)
  INT sum:
  [8]INT came:
  SEQ
    sum := number
    SEQ round = 0 FOR rounds
      SEQ
        PAR
          PAR i = 0 FOR 8
            out[i] ! (sum TIMES (i + 3)) PLUS number
          PAR i = 0 FOR 8
            in[i] ? came[i]
        SEQ i = 0 FOR 8
          sum := (sum TIMES 7) PLUS came[i]
    result ! sum
:
PROC total (CHAN OF SP fs, ts, [9]CHAN OF INT in)
  INT x, sum:
  SEQ
    sum := 0
    SEQ i = 0 FOR 9
      SEQ
        in[i] ? x
        sum := (sum TIMES 5) PLUS x
    so.write.int (fs, ts, sum, 0)
    so.exit (fs, ts, sps.success)
:
)";

/// Returns what all_to_all prints.
std::string total_of_grid(int rounds) {
    std::vector<std::uint32_t> sums = {0, 1, 2, 3, 4, 5, 6, 7, 8};
    for (int round = 0; round < rounds; ++round) {
        const std::vector<std::uint32_t> before = sums;
        for (std::uint32_t to = 0; to < 9; ++to)
            for (std::uint32_t i = 0; i < 8; ++i) {
                const std::uint32_t from = i < to ? i : i + 1, out = to < from ? to : to - 1;
                sums[to] = sums[to] * 7 + before[from] * (out + 3) + from;
            }
    }
    std::uint32_t total = 0;
    for (const std::uint32_t each : sums)
        total = total * 5 + each;
    return std::to_string(static_cast<std::int32_t>(total));
}

constexpr const char* grid = R"(
val n 3;
T800 (memory = 64K) t[n][n];
rep y = 0 for n
  rep x = 0 for n - 1 {
    connect t[y][x].link[1] to t[y][x + 1].link[3];
    connect t[x][y].link[2] to t[x + 1][y].link[0];
  }
connect t[0][0].link[0] to host;
process cell[9], total;
use "grid.occ#cell" for cell; use "grid.occ#total" for total;
place total on t[0][0];
rep i = 0 for 9 {
  cell[i] (number = i, rounds = 4);
  place cell[i] on t[i / n][i % n];
  connect cell[i].result to total.in[i];
  rep j = 0 for 8
    if j < i { connect cell[j].out[i - 1] to cell[i].in[j]; }
    else { connect cell[j + 1].out[i] to cell[i].in[j]; }
}
)";

/// A farmer with workers that answer when they have finished.
constexpr const char* farm = R"(
#INCLUDE "hostio.inc"
#USE "hostio.lib"
PROC worker (CHAN OF INT task, result)
  INT n, x:
  SEQ
    n := 0
    WHILE n >= 0
      SEQ
        task ? n
        IF
          n < 0
            SKIP
          TRUE
            SEQ
              x := 0
              SEQ i = 0 FOR n
                x := x + (i * i)
              result ! x
:
PROC farmer (CHAN OF SP fs, ts, []CHAN OF INT task, result)
  INT next, sum, x:
  SEQ
    sum := 0
    next := SIZE task
    SEQ i = 0 FOR SIZE task
      task[i] ! i
    SEQ answer = 0 FOR 40
      ALT i = 0 FOR SIZE task
        result[i] ? x
          SEQ
            sum := sum + x
            IF
              next < 40
                SEQ
                  task[i] ! next
                  next := next + 1
              TRUE
                task[i] ! -1
    so.write.int (fs, ts, sum, 0)
    so.exit (fs, ts, sps.success)
:
)";

std::string farm_on(const std::string& wires, int nodes) {
    return fmt::format(R"(
val n {};
T800 (memory = 64K) t[n + 1];
{}
process farmer, worker[n];
use "farm.occ#farmer" for farmer; use "farm.occ#worker" for worker;
place farmer on t[0];
rep i = 0 for n {{
  place worker[i] on t[i + 1];
  connect farmer.task[i] to worker[i].task; connect worker[i].result to farmer.result[i];
}}
)",
                       nodes, wires);
}

test::RunOfNetwork run_shuffled(const std::filesystem::path& netlist, std::optional<std::uint64_t> shuffle) {
    const Catalogue catalogue = test::occam_catalogue();
    return test::run_network(netlist, catalogue, {}, {}, shuffle);
}

} // namespace

namespace {

void check_random_traffic(std::size_t programs) {
    for (const std::uint64_t seed : test::seeds(programs)) {
        INFO(test::replay(seed));
        const test::RandomTraffic traffic = test::random_traffic(seed);
        const test::FilesOfNetwork files(traffic.files);
        CHECK(run_shuffled(files.path("one.cfs"), {}).screen == traffic.printed);
        const auto shuffle = seed % 2 == 0 ? std::nullopt : std::optional(seed);
        CHECK(run_shuffled(files.path("many.cfs"), shuffle).screen == traffic.printed);
    }
}

} // namespace

TEST_CASE("random programs give the same on several processors as on one, and as a model") { check_random_traffic(50); }

TEST_CASE("a thousand random programs give the same on several processors as on one" * doctest::skip()) {
    check_random_traffic(1000);
}

TEST_CASE("nine processes on a grid send to all others at once") {
    const test::FilesOfNetwork files({{"grid.occ", all_to_all}, {"grid.cfs", grid}});
    for (const std::uint64_t seed : test::seeds(4))
        CHECK(run_shuffled(files.path("grid.cfs"), seed == 0 ? std::nullopt : std::optional(seed)).screen ==
              total_of_grid(4));
}

TEST_CASE("a farm works on a chain and on a ring") {
    const std::string chained = "connect t[0].link[0] to host;\n"
                                "rep i = 0 for n connect t[i].link[2] to t[i + 1].link[1];\n";
    const std::string ring = chained + "connect t[n].link[2] to t[0].link[1];\n";
    std::int64_t sum = 0;
    for (std::int64_t n = 0; n < 40; ++n)
        for (std::int64_t i = 0; i < n; ++i)
            sum += i * i;
    for (const std::string& wires : {chained, ring})
        for (const int workers : {2, 5}) {
            const test::FilesOfNetwork files({{"farm.occ", farm}, {"farm.cfs", farm_on(wires, workers)}});
            CHECK(run_shuffled(files.path("farm.cfs"), {}).screen == std::to_string(sum));
            CHECK(run_shuffled(files.path("farm.cfs"), 5).screen == std::to_string(sum));
        }
}

TEST_CASE("a run is complete when the processes have ended, though what carries their messages has not") {
    for (const char* more : {"", "p (priority = HIGH);", "p (priority = HIGH); q (priority = HIGH);"}) {
        const test::FilesOfNetwork files({{"pair.occ", pair_of_channels}, {"chain.cfs", chain(5, 5, more)}});
        const RunReport report = run_shuffled(files.path("chain.cfs"), {}).report;
        CHECK(report.result.ending == Ending::completed);
        CHECK(report.programs.size() == 3); // also one for the processor between
    }
}

TEST_CASE("a report names the processes at the ends of a channel, and nothing that is between them") {
    const test::FilesOfNetwork files({{"pair.occ", pair_of_channels}, {"chain.cfs", chain(9, 4)}});
    const RunReport report = run_shuffled(files.path("chain.cfs"), {}).report;
    REQUIRE(report.result.deadlock);
    std::vector<StuckProcess> stuck = report.result.deadlock->processes;
    std::erase_if(stuck, [](const StuckProcess& each) { return each.path.starts_with("the code of"); });
    REQUIRE(stuck.size() == 1); // q has ended
    CHECK(stuck[0].path == "p");
    CHECK(stuck[0].activity == Activity::inputting); // its last messages have left, though q does not take them
    REQUIRE(stuck[0].channels.size() == 1);
    CHECK(stuck[0].channels[0] == "q.back -> p.back");
}

TEST_CASE("two processes that wait for each other over a third processor are a cycle") {
    constexpr const char* both = "PROC both (CHAN OF INT out, in)\n  INT x:\n  SEQ i = 0 FOR 3\n    SEQ\n"
                                 "      out ! i\n      out ! i\n      out ! i\n      in ? x\n:\n";
    const test::FilesOfNetwork files({{"both.occ", both}, {"a.cfs", R"(
T800 a, m, b;
connect a.link[0] to m.link[1];
connect m.link[0] to b.link[1];
process p, q;
use "both.occ" for p; use "both.occ" for q;
place p on a; place q on b;
connect p.out to q.in; connect q.out to p.in;
)"}});
    const RunReport report = run_shuffled(files.path("a.cfs"), {}).report;
    REQUIRE(report.result.deadlock);
    CHECK(report.result.deadlock->cycle == std::vector<std::string>{"p", "q"});
    for (const StuckChannel& each : report.result.deadlock->channels) {
        const bool is_first = each.name == "p.out -> q.in";
        CHECK((is_first || each.name == "q.out -> p.in"));
        CHECK(each.outputter == (is_first ? "p" : "q"));
        CHECK(each.inputter == (is_first ? "q" : "p"));
    }
}

TEST_CASE("counted arrays have room on their way: those of texts, parameters, and arrays seen as bytes") {
    const std::string long_text(700, 'x');
    const test::FilesOfNetwork files({{"long.occ", fmt::format(R"(
#INCLUDE "hostio.inc"
#USE "hostio.lib"
PROC give (VAL []BYTE parameter, CHAN OF INT::[]BYTE a, b)
  [300]INT words:
  SEQ
    SEQ i = 0 FOR 300
      words[i] := i
    a ! 700::"{}"
    b ! 0::parameter
    b ! SIZE parameter::parameter
    []BYTE bytes RETYPES words:
    a ! SIZE bytes::bytes
:
PROC take (CHAN OF SP fs, ts, CHAN OF INT::[]BYTE a, b)
  INT n, m, k, l:
  [3000]BYTE x:
  SEQ
    a ? n::x
    b ? k::x
    b ? k::x
    a ? m::x
    so.write.int (fs, ts, n, 0)
    so.write.int (fs, ts, k, 6)
    so.write.int (fs, ts, m, 6)
    so.write.int (fs, ts, INT x[4], 6)
    so.exit (fs, ts, sps.success)
:
)",
                                                               long_text)},
                                      {"long.cfs", fmt::format(R"(
T800 (memory = 64K) a, b;
connect a.link[0] to b.link[1];
connect b.link[0] to host;
process p, q;
use "long.occ#give" for p; use "long.occ#take" for q;
p (parameter = "{}");
place p on a; place q on b;
connect p.a to q.a; connect p.b to q.b;
)",
                                                               long_text + long_text)}});
    CHECK(run_shuffled(files.path("long.cfs"), {}).screen == "700  1400  1200     1");
}

TEST_CASE("beside what carries messages, a process may have a PRI PAR or a terminal") {
    const test::FilesOfNetwork files({{"pair.occ", std::string(pair_of_channels) + R"(
PROC with.priority (CHAN OF INT a, b, back, CHAN OF BYTE screen!)
  CHAN OF INT c:
  PRI PAR
    INT x:
    SEQ i = 0 FOR 5
      SEQ
        c ? x
        screen ! BYTE (x + (INT '0'))
    INT x, y:
    SEQ i = 0 FOR 5
      SEQ
        a ? x
        b ? y
        back ! x
        c ! y
:
)"},
                                      {"a.cfs", R"(
T800 (memory = 64K) a, b;
connect a.link[0] to b.link[1];
connect b.link[0] to host;
process p, q;
use "pair.occ#give" for p; use "pair.occ" for q;
p (count = 5);
place p on a; place q on b;
connect p.a to q.a; connect p.b to q.b; connect q.back to p.back;
)"}});
    CHECK(run_shuffled(files.path("a.cfs"), {}).screen == "12345");
}
