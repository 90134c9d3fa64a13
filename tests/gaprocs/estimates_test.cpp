// Tests the estimates that islands send to the host after the generations of each sample.

#include "tests/gaprocs/island_netlist.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <string>

using namespace placedpar;
using test::IslandNetlist;

namespace {

constexpr std::size_t islands = 4;

IslandNetlist four_islands() {
    SearchSettings each;
    each.population = 16;
    each.window.first = each.window.length; // T_exe counts only generations with a full window
    IslandNetlist netlist{};
    netlist.settings.islands.assign(islands, each);
    netlist.on = IslandNetlist::On::four_transputers;
    return netlist;
}

/// Returns the netlist, in which the islands from `first` on send estimates to the host.
std::string returning(const IslandNetlist& netlist, std::size_t first = 0) {
    std::string text = netlist.text();
    for (std::size_t i = first; i < islands; ++i)
        text += fmt::format("connect island[{}].to_host to host.from_masters[{}];\n", i, i - first);
    return text;
}

/// Returns the number of samples after which an island makes generations: from the first full window on.
std::size_t samples_searched() { return line_samples - SearchSettings{}.window.length + 1; }

double generations_ms(const RunReport& report, std::size_t island, double trials) {
    return trials * report.measured(fmt::format("island[{}]", island), "T_exe");
}

void check_best_is_of_its_island(const RunReport& report) {
    std::string best = report.measured_text("host", "best_of");
    REQUIRE(best.starts_with("island["));
    for (const char* name : {"best_fitness", "slope"})
        CHECK(report.measured("host", name) == report.measured(best, name));
    for (std::size_t i = 0; i < islands; ++i)
        CHECK(report.measured("host", "best_fitness") >= report.measured(fmt::format("island[{}]", i), "best_fitness"));
}

} // namespace

TEST_CASE("an estimate comes after every sample with generations, and estimates do not change the generations") {
    IslandNetlist netlist = four_islands();
    RunReport silent = run_on_line(netlist.text()), report = run_on_line(returning(netlist));
    REQUIRE(report.result.ending == Ending::completed);
    for (std::size_t i = 0; i < islands; ++i) {
        std::string island = fmt::format("island[{}]", i);
        CHECK(report.measured_text(island, "populations") == silent.measured_text(island, "populations"));
    }
    CHECK(report.measured("host", "estimates") == islands * samples_searched());
    check_best_is_of_its_island(report);
}

TEST_CASE("the response time of an estimate is the time of a sample's generations, apart from the time on the links") {
    RunReport report = run_on_line(returning(four_islands()));
    double generations = generations_ms(report, 0, 5), response = report.measured("host", "response");
    CHECK(response == doctest::Approx(generations).epsilon(0.005));
    CHECK(report.measured("host", "longest_response") >= response);
    IslandNetlist more_trials = four_islands();
    for (SearchSettings& each : more_trials.settings.islands)
        each.window.trials = 10;
    RunReport longer = run_on_line(returning(more_trials));
    CHECK(longer.measured("host", "response") == doctest::Approx(generations_ms(longer, 0, 10)).epsilon(0.005));
    CHECK(longer.measured("host", "response") > 1.9 * response);
}

TEST_CASE("some islands may send estimates while others do not") {
    RunReport report = run_on_line(returning(four_islands(), 2));
    REQUIRE(report.result.ending == Ending::completed);
    CHECK(report.measured("host", "estimates") == 2 * samples_searched());
    std::string best = report.measured_text("host", "best_of");
    bool of_those = best == "island[2]" || best == "island[3]";
    CHECK(of_those);
}

TEST_CASE("islands on workstations, which take no time, answer at once") {
    IslandNetlist netlist = four_islands();
    netlist.on = IslandNetlist::On::workstations;
    netlist.wire = "linkspeed = 20M";
    RunReport report = run_on_line(returning(netlist));
    REQUIRE(report.result.ending == Ending::completed);
    CHECK(report.measured("host", "estimates") == islands * samples_searched());
    CHECK(report.measured("host", "response") < 1);
}

TEST_CASE("an island may not send estimates to a host from which it does not get its samples") {
    std::string text = four_islands().text() +
                       "process other; use \"ga.host\" for other; place other on sun; other (problem = \"line\");\n"
                       "process master; use \"ga.master\" for master; place master on t0; master (problem = "
                       "\"line\");\nconnect other.to_masters to master.from_host;\n"
                       "connect island[1].to_host to other.from_masters[0];\n";
    CHECK_THROWS_WITH(run_on_line(text), doctest::Contains("error: \"other.from_masters[0]\" receives estimates from a "
                                                           "process that does not get its samples from this host"));
    CHECK_THROWS_WITH(
        run_on_line(text),
        doctest::Contains(
            "hint: connect other.to_masters[...] to the from_host of the process that sends the estimates"));
}
