// Tests that a problem's record is made only when a process reads it.

#include "explore/problems.hpp"

#include "explore/load.hpp"
#include "explore/netlist_run.hpp"
#include "hydraulics/circuit/circuit_sample.hpp"
#include "report/kinds_report.hpp"

#include <doctest/doctest.h>

using namespace placedpar;

namespace {

/// The program's boom problem, counting how often its record is made.
struct CountedBoom {
    ProblemRegistry problems;
    int made = 0;

    CountedBoom() {
        RecordedProblem boom = known_problems(1).find("boom");
        problems.add_to_make("boom", boom.problem(), {boom.samples(), [this, boom] {
                                                          ++made;
                                                          return boom.record();
                                                      }});
    }
    CountedBoom(const CountedBoom&) = delete;
    CountedBoom& operator=(const CountedBoom&) = delete;
};

const std::filesystem::path cluster = PLACEDPAR_SOURCE_DIR "/examples/thesis/table-e1/cluster.cfs";

void no_warning(const std::string& warning) { FAIL(warning); }

} // namespace

TEST_CASE("listing the kinds and describing one makes no record") {
    CountedBoom boom;
    Catalogue catalogue = known_kinds(boom.problems);
    CHECK(print_kinds(catalogue).find("ga.host") != std::string::npos);
    CHECK(print_kind(catalogue, "ga.host").find("default \"boom\"") != std::string::npos);
    CHECK(boom.made == 0);
}

TEST_CASE("checking a netlist makes no record, running it makes one") {
    CountedBoom boom;
    Network network = load_network(cluster, {{"slaves", "1"}}, boom.problems, no_warning);
    CHECK(boom.made == 0);
    CHECK(run_netlist(network, boom.problems, {.seed = 1}).result.ending == Ending::completed);
    CHECK(boom.made == 1);
}

TEST_CASE("the check of a record's length makes no record") {
    CountedBoom boom;
    CHECK_THROWS_AS(load_network(cluster, {{"samples", "21"}}, boom.problems, no_warning), std::runtime_error);
    CHECK(boom.made == 0);
}

TEST_CASE("the boom's record has the promised length, whatever its noise") {
    for (std::uint64_t seed = 0; seed < 100; ++seed)
        CHECK(known_problems(seed).find("boom").record().size() == hydraulics::UsableSamples().count);
}

TEST_CASE("a request ends a run that begins after it") {
    CountedBoom boom;
    Interruption interruption;
    interruption.request();
    Network network = load_network(cluster, {}, boom.problems, no_warning);
    RunReport report = run_netlist(network, boom.problems, {.seed = 1, .interruption = &interruption});
    CHECK(report.result.ending == Ending::interrupted);
}
