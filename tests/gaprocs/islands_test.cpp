// Tests algorithm B on the simulated machine against the library's islands.

#include "tests/gaprocs/island_netlist.hpp"
#include "tests/sanitized.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

using namespace placedpar;
using test::IslandNetlist;
using test::LibraryRun;

namespace {

// The first tests have rings of masters with slaves.

std::vector<RandomStream> streams_of_masters(std::size_t islands) {
    std::vector<RandomStream> streams;
    for (std::size_t i = 0; i < islands; ++i)
        streams.emplace_back(1, fmt::format("master{}", i));
    return streams;
}

void check_ring(const Cluster& cluster) {
    RunReport report = run_on_line(cluster.netlist());
    CHECK(report.result.ending == Ending::completed);
    SearchSettings each;
    each.population = static_cast<std::size_t>(cluster.population);
    IslandsSettings settings;
    settings.islands.assign(static_cast<std::size_t>(cluster.islands), each);
    LibraryRun expected(settings, streams_of_masters(settings.islands.size()));
    for (int i = 0; i < cluster.islands; ++i)
        CHECK(report.measured_text(fmt::format("master{}", i), "populations") ==
              expected.populations[static_cast<std::size_t>(i)]);
}

// The next tests have other topologies.

constexpr std::size_t eight = 8;

IslandsSettings alike_islands() {
    SearchSettings each;
    each.population = 16;
    each.elite = 1;
    each.window.trials = 2;
    IslandsSettings settings;
    settings.islands.assign(eight, each);
    return settings;
}

/// Returns settings of islands with different populations (some odd), windows and biases: a distributed fitness
/// function.
IslandsSettings different_islands() {
    IslandsSettings settings = alike_islands();
    const std::vector<std::size_t> populations{17, 16, 19, 20, 16, 18, 21, 16}, windows{10, 7, 10, 3, 10, 5, 7, 9};
    for (std::size_t i = 0; i < eight; ++i) {
        settings.islands[i].population = populations[i];
        settings.islands[i].window.length = windows[i];
    }
    settings.islands[4].window.bias = 200;
    return settings;
}

/// A random topology; island 3 only receives.
const Neighbours drawn{{1, 2, 3}, {0}, {4}, {}, {5}, {6, 7}, {2}, {0, 5}};

std::vector<Topology> topologies() {
    return {RingTopology{}, RingTopology{2},    HypercubeTopology{}, TorusTopology{2},
            StarTopology{}, CompleteTopology{}, NoTopology{},        GivenTopology{drawn}};
}

void check_same_as_library(const IslandNetlist& netlist) {
    CAPTURE(netlist.settings.topology.text());
    CAPTURE(netlist.settings.schedule.text());
    CAPTURE(netlist.settings.emigration.text());
    CAPTURE(netlist.settings.acceptance.text());
    RunReport report = run_on_line(netlist.text());
    REQUIRE(report.result.ending == Ending::completed);
    LibraryRun expected(netlist.settings, island_streams(1, eight));
    for (std::size_t i = 0; i < eight; ++i) {
        std::string name = fmt::format("island[{}]", i);
        CHECK(report.measured_text(name, "populations") == expected.populations[i]);
    }
}

double execution_ms(const IslandsSettings& settings) {
    IslandNetlist netlist{settings, IslandNetlist::On::four_transputers};
    return run_on_line(netlist.text()).measured("island[1]", "T_exe");
}

} // namespace

TEST_CASE("islands in a ring exchange their bests every third generation, as in the library") {
    check_ring({.islands = 2, .population = 10});
    check_ring({.islands = 4, .population = 30});
}

TEST_CASE("islands with slaves exchange their bests every third generation, as in the library") {
    check_ring({.slaves = 3, .islands = 4, .population = 30});
    check_ring({.slaves = 2, .islands = 3, .population = 9, .split = "evaluations"});
}

TEST_CASE("islands that exchange have other populations than islands that do not") {
    Cluster exchanging{.islands = 2, .population = 10};
    Cluster rarely{.islands = 2, .population = 10, .master_parameters = "rehearsals = 1, exchange_every = 1000"};
    CHECK(run_on_line(exchanging.netlist()).measured_text("master0", "populations") !=
          run_on_line(rarely.netlist()).measured_text("master0", "populations"));
}

TEST_CASE("island processes have the library's generations with every topology, schedule, emigration and acceptance") {
    test::EveryNth sampled(41);
    for (bool different : {false, true})
        for (const Topology& topology : topologies())
            for (const char* schedule : {"broadcast(2)", "sequential(1)"})
                for (const char* emigration : {"best", "random(2)", "tournament(2, 3)"})
                    for (const char* acceptance :
                         {"worst", "worst(1)", "random", "random(1)", "alike", "alike(1)", "offspring"}) {
                        if (sampled.passes_over())
                            continue;
                        IslandNetlist netlist{different ? different_islands() : alike_islands()};
                        netlist.settings.topology = topology;
                        netlist.settings.schedule = Schedule::named(schedule);
                        netlist.settings.emigration = Emigration::named(emigration);
                        netlist.settings.acceptance = Acceptance::named(acceptance);
                        check_same_as_library(netlist);
                    }
}

TEST_CASE("generations do not depend on placement or on the speed of links and processors") {
    using On = IslandNetlist::On;
    test::EveryNth sampled(13);
    for (const Topology& topology : topologies())
        for (const char* schedule : {"broadcast(1)", "sequential(2)"}) {
            if (sampled.passes_over())
                continue;
            IslandNetlist netlist{different_islands()};
            netlist.settings.topology = topology;
            netlist.settings.schedule = Schedule::named(schedule);
            netlist.settings.acceptance = RandomAcceptance{};
            for (On on : {On::one_transputer, On::four_transputers, On::workstations})
                for (const char* wire : {"linkspeed = 5M", "linkspeed = 20M"}) {
                    netlist.on = on;
                    netlist.wire = wire;
                    check_same_as_library(netlist);
                }
            netlist.on = On::four_transputers;
            netlist.other_transputer = "clock = 30M";
            check_same_as_library(netlist);
            netlist.more = ", cycles_per_error = 0, cycles_per_individual = 0";
            check_same_as_library(netlist);
        }
}

TEST_CASE("a named topology determines the order of neighbours, however they are connected") {
    Neighbours cube = Topology(HypercubeTopology{}).neighbours(eight), shuffled = cube;
    for (std::size_t i = 0; i < eight; ++i)
        std::rotate(shuffled[i].begin(), shuffled[i].begin() + static_cast<std::ptrdiff_t>(i % 3), shuffled[i].end());
    IslandNetlist netlist{alike_islands()};
    netlist.settings.topology = GivenTopology{shuffled};
    netlist.settings.schedule = SequentialSchedule{1};
    check_same_as_library(netlist); // in the order of the connections
    auto populations = [](const IslandNetlist& each) {
        return run_on_line(each.text()).measured_text("island[1]", "populations");
    };
    std::string as_connected = populations(netlist);
    netlist.topology = "hypercube";
    IslandsSettings named = netlist.settings;
    named.topology = HypercubeTopology{};
    CHECK(populations(netlist) == LibraryRun(named, island_streams(1, eight)).populations[1]);
    CHECK(populations(netlist) != as_connected);
}

TEST_CASE(
    "an immigrant from another window is evaluated again, which takes time; an immigrant among the offspring is not") {
    IslandsSettings same = alike_islands(), different = same;
    same.islands.resize(4);
    different.islands.resize(4);
    different.islands[1].window.bias = 200;
    for (IslandsSettings* each : {&same, &different})
        each->schedule = BroadcastSchedule{1};
    double evaluation_ms = 10 * 1440 * 50e-6; // a window of 10, 1440 cycles of 50 ns
    double same_ms = execution_ms(same), different_ms = execution_ms(different);
    CHECK(std::abs(different_ms - same_ms - evaluation_ms) < 0.1);
    same.acceptance = different.acceptance = OffspringAcceptance{};
    CHECK(std::abs(execution_ms(different) - execution_ms(same)) < 0.1);
}

// The last tests have asynchronous exchange.

TEST_CASE("asynchronous exchange ends in every topology and placement, and the same machine gives the same run") {
    using On = IslandNetlist::On;
    std::set<std::string> runs;
    IslandNetlist without{different_islands()};
    without.settings.topology = NoTopology{};
    std::string alone = run_on_line(without.text()).measured_text("island[0]", "populations");
    test::EveryNth sampled(5);
    for (const Topology& topology : topologies())
        for (On on : {On::one_transputer, On::four_transputers, On::workstations}) {
            if (sampled.passes_over())
                continue;
            IslandNetlist netlist{different_islands(), on};
            netlist.settings.topology = topology;
            netlist.settings.schedule = AsynchronousSchedule{1};
            netlist.other_transputer = "clock = 30M";
            CAPTURE(topology.text());
            RunReport report = run_on_line(netlist.text()), again = run_on_line(netlist.text());
            CHECK(report.result.ending == Ending::completed);
            CHECK(report.result.fingerprint == again.result.fingerprint);
            CHECK(report.measured("island[0]", "generations") == 16); // two for each of 8 samples, from the fifth on
            CHECK(report.measured("island[3]", "generations") == 20); // this island does not wait for any other
            CHECK(report.measured_text("island[0]", "populations") == again.measured_text("island[0]", "populations"));
            CHECK((report.measured_text("island[0]", "populations") != alone) == topology.exchanges());
            runs.insert(report.measured_text("island[0]", "populations"));
        }
    CHECK(runs.size() > (test::sanitized ? 1 : 8)); // the result depends on the machine
}

TEST_CASE("asynchronous islands may have slaves") {
    for (const char* more : {"rehearsals = 2, schedule = \"asynchronous(2)\"",
                             "rehearsals = 2, schedule = \"asynchronous\", exchange_every = 1, acceptance = "
                             "\"offspring\""}) {
        Cluster cluster{.slaves = 2, .islands = 3, .population = 9, .master_parameters = more};
        RunReport report = run_on_line(cluster.netlist());
        CHECK(report.result.ending == Ending::completed);
        CHECK(report.measured("master1", "generations") == 40);
        CHECK(report.measured("master1", "C_time2") > 0);
    }
}
