// Tests the times that masters and slaves measure.

#include "gaprocs/processes/share.hpp"
#include "tests/gaprocs/cluster.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

using namespace placedpar;

namespace {

bool has(const RunReport& report, std::string_view measure) {
    return std::ranges::any_of(report.measurements, [&](const Measurement& m) { return m.name == measure; });
}

} // namespace

TEST_CASE("a high-priority master that deals on demand measures its evaluations with the low-priority clock") {
    auto netlist = [](const char* priority) {
        std::string text = Cluster{.slaves = 2, .split = "demand"}.netlist();
        std::string process = "process (interface (input from_host";
        text.replace(text.find(process), process.size(),
                     fmt::format("process (priority = {}, interface (input from_host", priority));
        return text;
    };
    double low = run_on_line(netlist("LOW")).measured("master0", "P_time2");
    double high = run_on_line(netlist("HIGH")).measured("master0", "P_time2");
    // The master evaluates nine to eleven of 30 individuals, each at 10 samples. An error takes 1440 cycles of 50 ns,
    // so this takes 6.5 to 7.9 ms.
    CHECK(low > 6);
    CHECK(low < 9);
    CHECK(high == doctest::Approx(low).epsilon(0.1));
}

TEST_CASE("times are measured only with a full window") {
    Cluster never_full{.slaves = 2};
    RunReport report = run_on_line(never_full.netlist() + "host (samples = 7);\n");
    CHECK(report.measured("master0", "generations") == 15); // 3 samples from the fifth on, with 5 trials each
    for (const char* time : {"T_exe", "T_sr", "P_time2", "C_time2", "S_time2", "generations_per_second"})
        CHECK_FALSE(has(report, time));
    CHECK(has(run_on_line(never_full.netlist() + "host (samples = 10);\n"), "T_exe"));
}

TEST_CASE("a run that takes no time reports no generations per second") {
    std::string text =
        "workstation sun; process host; process m; use \"ga.host\" for host; use \"ga.traditional\" for m;\n"
        "host (problem = \"line\"); m (problem = \"line\");\n"
        "connect host.to_masters[0] to m.from_host; place host on sun; place m on sun;\n";
    RunReport report = run_on_line(text);
    CHECK(report.result.time == Time{0});
    CHECK(report.measured("m", "generations") == 40); // 8 samples, from the fifth to the twelfth
    CHECK_FALSE(has(report, "generations_per_second"));
}

TEST_CASE("rehearsals do not change the measured times of the work") {
    auto run = [](int islands, int rehearsals) {
        return run_on_line(
            Cluster{.slaves = 2, .islands = islands, .master_parameters = fmt::format("rehearsals = {}", rehearsals)}
                .netlist());
    };
    for (int islands : {1, 3}) {
        RunReport few = run(islands, 1), many = run(islands, 50), none = run(islands, 0);
        CHECK(many.result.ending == Ending::completed);
        for (const RunReport& other : {few, none}) {
            CHECK(many.result.time == other.result.time);
            CHECK(std::ranges::equal(many.processors, other.processors, {}, &ProcessorUse::busy, &ProcessorUse::busy));
            CHECK(std::ranges::equal(many.links, other.links, {}, &LinkUse::bytes, &LinkUse::bytes));
            CHECK(std::ranges::equal(many.processes, other.processes, {}, &ProcessUse::waiting, &ProcessUse::waiting));
        }
        for (const char* time : {"T_exe", "T_sr", "P_time2", "S_time2"})
            CHECK(many.measured("master0", time) == none.measured("master0", time));
        CHECK(many.measured("master0", "C_time2") == doctest::Approx(few.measured("master0", "C_time2")).epsilon(0.1));
        CHECK_FALSE(has(none, "C_time2"));
        CHECK(std::ranges::none_of(many.processes, [](const ProcessUse& p) { return p.waits_since.has_value(); }));
    }
}

TEST_CASE("results in the order of the chain take longer than results that are passed on when they are ready") {
    // With so many rehearsals the resolution of the clock, 64 us, does not matter.
    Cluster in_order{.slaves = 3, .master_parameters = "rehearsals = 50"};
    Cluster ready{.slaves = 3, .master_parameters = "rehearsals = 50, results = \"ready\""};
    RunReport chain = run_on_line(in_order.netlist()), any = run_on_line(ready.netlist());
    CHECK(any.measured("master0", "C_time2") < 0.99 * chain.measured("master0", "C_time2"));
    CHECK(any.measured_text("master0", "populations") == chain.measured_text("master0", "populations"));
}

TEST_CASE("dealing on demand sends one message for each individual, which costs more communication") {
    auto netlist = [](const char* split) {
        return Cluster{.slaves = 1, .split = split, .master_parameters = "rehearsals = 100"}.netlist();
    };
    double round = run_on_line(netlist("individuals")).measured("master0", "C_time2");
    double demand = run_on_line(netlist("demand")).measured("master0", "C_time2");
    // There are 15 tasks and 15 results instead of one of each. In both cases the 148 bytes of measurements are sent
    // once.
    CHECK(demand > 2 * round);
    CHECK(demand < 15 * round);
}

TEST_CASE("no share has more individuals than most_individuals() states, whatever the window") {
    for (Split split : {Split::individuals, Split::evaluations})
        for (std::size_t population : {2u, 7u, 30u, 31u})
            for (std::size_t slaves = 1; slaves < population; ++slaves)
                for (std::size_t window = 1; window <= 12; ++window)
                    for (double own_share : {0.0, .3, 1.0}) {
                        auto shares = deal(population, window, slaves, split, own_share);
                        shares.pop_back(); // the master's share is not in a message
                        for (const Share& share : shares)
                            CHECK(share.individuals() <= most_individuals(population, slaves, split, own_share));
                    }
    CHECK(most_individuals(120, 3, Split::individuals) == 30);
    CHECK(most_individuals(30, 3, Split::individuals) == 8);
    CHECK(most_individuals(30, 3, Split::demand) == 1);
}

TEST_CASE("the master's share is the stated fraction of a slave's share, and all work is dealt out once") {
    for (double own_share : {0.0, .25, .5, 1.0})
        for (std::size_t slaves : {0u, 1u, 3u, 7u}) {
            auto shares = deal(30, 10, slaves, Split::evaluations, own_share);
            REQUIRE(shares.size() == slaves + 1);
            std::size_t next = 0;
            for (const Share& share : shares) {
                CHECK(share.first == next);
                next = share.last;
            }
            CHECK(next == 300);
            auto own = static_cast<double>(shares.back().evaluations());
            if (slaves > 0)
                CHECK(std::abs(own - own_share * static_cast<double>(shares.front().evaluations())) <= 2);
        }
}
