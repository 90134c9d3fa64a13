// Tests runs of netlists that must complete for an experiment.

#include "experiments/kit/experiment_runs.hpp"

#include "tests/experiments/kit/replay_in_memory.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>

#include <cstdint>
#include <filesystem>
#include <string>

using namespace placedpar;

namespace {

const std::filesystem::path own_examples = std::filesystem::path(PLACEDPAR_SOURCE_DIR) / "examples";

/// Returns how the run of this netlist failed, or `completed`.
RunOutcome outcome_of(const test::ReplayInMemory& replay, const char* netlist) {
    try {
        return run_to_the_end(own_examples / netlist, {}, replay.context).outcome();
    } catch (const UnfinishedRun& unfinished) {
        return unfinished.outcome;
    }
}

} // namespace

TEST_CASE("a completed run is reported; a stuck or interrupted run is not") {
    test::ReplayInMemory replay(0);
    CHECK(outcome_of(replay, "csp/commstime/commstime.cfs") == RunOutcome::completed);
    CHECK(outcome_of(replay, "csp/deadlock/ring.cfs") == RunOutcome::deadlock);
    replay.interruption.request();
    CHECK(outcome_of(replay, "csp/commstime/commstime.cfs") == RunOutcome::interrupted);
    CHECK_THROWS_WITH_AS(run_to_the_end(own_examples / "csp/commstime/commstime.cfs", {}, replay.context),
                         doctest::Contains("interrupted: the experiment is incomplete"), UnfinishedRun);
    CHECK(replay.warned.empty());
}

TEST_CASE("a setting that the netlist refuses throws the refusal") {
    test::ReplayInMemory replay(0);
    CHECK_THROWS_WITH_AS(run_to_the_end(own_examples / "csp/commstime/commstime.cfs", {{"cuont", "5"}}, replay.context),
                         doctest::Contains("\"cuont\""), RefusedInput);
}

TEST_CASE("only a completed run has results; the message names the netlist and where to look") {
    for (Ending ending : {Ending::stuck, Ending::time_limit, Ending::interrupted}) {
        RunReport report;
        report.result.ending = ending;
        try {
            require_end(report, "folder/machine.cfs");
            FAIL("an incomplete run was accepted");
        } catch (const UnfinishedRun& unfinished) {
            CHECK(unfinished.outcome == report.outcome());
            CHECK(unfinished.what() ==
                  std::string("folder/machine.cfs did not complete: placedpar run shows where it stopped"));
        }
    }
    RunReport complete;
    complete.result.ending = Ending::completed;
    CHECK_NOTHROW(require_end(complete, "machine.cfs"));
}

TEST_CASE("an interruption that nobody requested ends nothing") {
    Interruption interruption;
    CHECK_NOTHROW(end_if_requested(interruption));
    interruption.request();
    CHECK_THROWS_WITH_AS(end_if_requested(interruption),
                         "interrupted: the experiment is incomplete, so no table or plot was made", UnfinishedRun);
    CHECK_THROWS_AS(end_if_requested(interruption), UnfinishedRun); // it stays requested
}

TEST_CASE("the seed and the settings of a replay are those of its run") {
    const auto fingerprint = [](std::uint64_t seed, const char* count) {
        test::ReplayInMemory replay(0);
        replay.context.seed = seed;
        return run_to_the_end(own_examples / "csp/commstime/commstime.cfs", {{"count", count}}, replay.context)
            .result.fingerprint;
    };
    CHECK(fingerprint(1, "5") == fingerprint(1, "5"));
    CHECK(fingerprint(1, "5") != fingerprint(1, "6"));
    CHECK_THROWS_AS(fingerprint(1, "-1"), RefusedInput);
    const auto compliance = [](std::uint64_t seed) {
        test::ReplayInMemory replay(0);
        replay.context.seed = seed;
        return run_to_the_end(own_examples / "thesis/table-e1/cluster.cfs", {{"slaves", "0"}, {"samples", "11"}},
                              replay.context)
            .measured("master", "C_BOi");
    };
    CHECK(compliance(1) == compliance(1));
    CHECK(compliance(1) != compliance(2)); // another seed, another search
}
