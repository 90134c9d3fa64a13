// A worker that makes a study's runs one after the other must get the results of separate runs.

#include "explore/study/sweep.hpp"
#include "tests/sanitized.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

using namespace placedpar;

namespace {

Study study_of(const std::string& netlist, const std::vector<std::string>& settings, std::uint64_t seeds) {
    Study study;
    study.netlist = fmt::format("{}/{}", PLACEDPAR_SOURCE_DIR, netlist);
    study.products.emplace_back();
    for (const std::string& setting : settings)
        study.products.back().axes.push_back(read_axis(setting));
    study.seeds = seeds;
    return study;
}

std::string all_of(const std::optional<StudyOutcome>& outcome) {
    REQUIRE(outcome);
    return fmt::format("{} {} {:016x} {:016x} {} {}", outcome->ended, to_string(outcome->time), outcome->fingerprint,
                       outcome->netlist_hash, outcome->refused, figures_text(outcome->figures));
}

/// Makes all runs with one worker, and each run with a new worker, which has no run to repeat. Returns the number of
/// runs that the first worker repeated.
std::uint64_t check_worker(const Study& study) {
    Interruption never;
    StudyWorker worker(study);
    for (std::uint64_t i = 0; i < study.count(); ++i) {
        StudyRun run = *study.at(i);
        CAPTURE(study.netlist);
        CAPTURE(i);
        CHECK(all_of(worker.outcome_of(run, never)) == all_of(StudyWorker(study).outcome_of(run, never)));
    }
    return worker.repeated();
}

} // namespace

TEST_CASE(
    "repeated runs of one combination give the same outcomes as separate runs, with one simulation of the machine") {
    const std::uint64_t seeds = test::sanitized ? 2 : 3;
    for (const auto& each : std::vector<std::pair<std::string, std::vector<std::string>>>{
             {"thesis/figure-e2/figure-e2.cfs", {"slaves=0,2", "host.samples=12"}},
             {"genetic/farms/farm.cfs",
              {"split=individuals,demand,evaluations", "sending=in turn,at once", "results=chain,ready", "links=2",
               "samples=6"}},
             {"genetic/islands/islands.cfs", {"schedule=broadcast,sequential", "host.samples=10"}},
             {"machine/through-routing/islands.cfs", {"host.samples=10"}},
             {"genetic/plant-on-transputers/islands.cfs", {"host.samples=40"}},
             {"genetic/coarse-fine/pair.cfs", {"host.samples=33"}},
             {"machine/figure-d1/figure-e2-on-d1.cfs", {"slaves=1", "host.samples=6"}},
             {"machine/busy-bus/busy-bus.cfs", {"messages=5"}},
             {"csp/commstime/commstime.cfs", {"count=9"}}}) {
        Study study = study_of("examples/" + each.first, each.second, seeds);
        CAPTURE(study.netlist);
        CHECK(check_worker(study) == study.count() / seeds * (seeds - 1));
    }
}

TEST_CASE("a worker reads the files of its netlist once") {
    const auto netlist = std::filesystem::temp_directory_path() / fmt::format("placedpar-once-{}.cfs", ::getpid());
    std::filesystem::copy_file(fmt::format("{}/examples/csp/commstime/commstime.cfs", PLACEDPAR_SOURCE_DIR), netlist);
    Study study = study_of("examples/csp/commstime/commstime.cfs", {"count=9", "linkspeed=5M,10M,20M"}, 1);
    study.netlist = netlist.string();
    std::vector<std::string> alone;
    Interruption never;
    for (std::uint64_t i = 0; i < study.count(); ++i)
        alone.push_back(all_of(StudyWorker(study).outcome_of(*study.at(i), never)));
    StudyWorker worker(study);
    std::filesystem::remove(netlist);
    for (std::uint64_t i = 0; i < study.count(); ++i)
        CHECK(all_of(worker.outcome_of(*study.at(i), never)) == alone[i]);
}

TEST_CASE("runs that depend on the order of processes are not repeated from a record") {
    CHECK(check_worker(
              study_of("examples/genetic/islands/islands.cfs", {"schedule=asynchronous", "host.samples=10"}, 2)) == 0);
    CHECK(check_worker(study_of("examples/machine/figure-d1/figure-e2-on-d1.cfs",
                                {"slaves=1", "host.samples=6", "host.accuracy=0.1"}, 2)) == 0);
    CHECK(check_worker(study_of("examples/machine/figure-d1/figure-e2-on-d1.cfs",
                                {"slaves=1", "host.samples=6", "broadcast=TRUE"}, 2)) == 0); // a broadcast compares
                                                                                             // messages
    CHECK(check_worker(study_of("examples/csp/philosophers/philosophers.cfs", {"meals=2"}, 2)) == 0);
}

TEST_CASE("a run that ends early is not repeated, and a run with a single seed is not recorded") {
    Study study = study_of("examples/csp/commstime/commstime.cfs", {}, 3);
    study.until = std::chrono::microseconds{50};
    CHECK(check_worker(study) == 0);
    CHECK(check_worker(study_of("examples/csp/deadlock/ring.cfs", {}, 3)) == 0);
    CHECK(check_worker(study_of("examples/csp/commstime/commstime.cfs", {"count=5,6"}, 1)) == 0);
}

TEST_CASE("an interruption ends a run that is repeated") {
    Interruption never, at_once;
    at_once.request();
    Study study = study_of("examples/csp/commstime/commstime.cfs", {}, 2);
    StudyWorker worker(study);
    REQUIRE(worker.outcome_of(*study.at(0), never));
    CHECK_FALSE(worker.outcome_of(*study.at(1), at_once));
    CHECK(worker.repeated() == 0);
    CHECK(worker.outcome_of(*study.at(1), never));
    CHECK(worker.repeated() == 1);
}

TEST_CASE("a readable netlist of a study is found wherever it lies among the combinations") {
    const std::string netlist = "examples/thesis/figure-e2/figure-e2.cfs";
    // A population of 1 is refused, at every thousandth combination.
    CHECK_NOTHROW(
        readable_network(study_of(netlist, {"slaves=0..999", "population=1..1000", "master.trials=1..1000"}, 1)));
    // One netlist in fifty has fewer slaves than individuals; all others are refused for their own values.
    CHECK_NOTHROW(readable_network(study_of(netlist, {"population=2..40", "slaves=0..999"}, 1)));
}

TEST_CASE("a study without a readable netlist is refused with the first netlist's refusal") {
    std::string said;
    try {
        readable_network(
            study_of("examples/thesis/figure-e2/figure-e2.cfs", {"slavs=0..999", "population=1..1000"}, 1));
    } catch (const UserError& refused) {
        said = refused.what();
    }
    CHECK(
        said.starts_with("--set:1:1: error: the netlist has no val, attribute or parameter \"slavs\"\n    slavs=0\n"));
}

TEST_CASE("a measure that no run has is refused after the first and last runs") {
    Interruption never;
    Study study = study_of("examples/genetic/farms/farm.cfs", {"slaves=1..3", "samples=6"}, 1);
    study.measures = {"master.generation"};
    StudyResults results(StudySource{});
    CHECK_THROWS_WITH_AS(StudySweep(study, results).try_measures(never),
                         "unknown measure \"master.generation\"; did you mean \"master.generations\"?", UserError);
    CHECK(results.count() == 2); // the first and the last
    CHECK_THROWS_WITH_AS(require_possible(study.measures, study, readable_network(study)),
                         doctest::Contains("did you mean \"master.generations\"?"), UserError);
    CHECK_NOTHROW(require_possible({"max(t.busy)", "master.T_exe"}, study, readable_network(study)));
}

TEST_CASE("the missing runs of a study are the runs not made yet, also after an interrupted sweep") {
    Study study;
    study.products = {{.axes = {read_axis("n=1..10")}, .where = StudyExpression("n != 4")}};
    study.function = [](const StudyRun&) { return StudyFigures(); };
    StudyResults results(StudySource{});
    StudySweep sweep(study, results);
    CHECK(sweep.missing().runs == 9);
    results.keep({{{"n", "7"}}, 1}, {.ended = "completed"});
    CHECK(sweep.missing().runs == 8);
    std::vector<std::string> made;
    while (std::optional<StudyRun> run = sweep.next())
        made.push_back(run->set.at("n"));
    CHECK(made == std::vector<std::string>{"1", "2", "3", "5", "6", "8", "9", "10"});
}
