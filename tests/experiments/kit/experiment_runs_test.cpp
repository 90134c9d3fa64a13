// Tests runs of netlists that must complete for an experiment.

#include "experiments/kit/experiment_runs.hpp"

#include "tests/experiments/kit/replay_in_memory.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>

#include <filesystem>

using namespace placedpar;

namespace {

const std::filesystem::path own_examples = std::filesystem::path(PLACEDPAR_SOURCE_DIR) / "examples";

/// Returns how the run of this netlist failed, or `completed`.
Ending ending_of(const test::ReplayInMemory& replay, const char* netlist) {
    try {
        return run_to_the_end(own_examples / netlist, {}, replay.context).result.ending;
    } catch (const UnfinishedRun& unfinished) {
        return unfinished.ending;
    }
}

} // namespace

TEST_CASE("a completed run is reported; a stuck or interrupted run is not") {
    test::ReplayInMemory replay(0);
    CHECK(ending_of(replay, "csp/commstime/commstime.cfs") == Ending::completed);
    CHECK(ending_of(replay, "csp/deadlock/ring.cfs") == Ending::stuck);
    replay.interruption.request();
    CHECK(ending_of(replay, "csp/commstime/commstime.cfs") == Ending::interrupted);
    CHECK(replay.warned.empty());
}

TEST_CASE("a setting that the netlist refuses throws the refusal") {
    test::ReplayInMemory replay(0);
    CHECK_THROWS_WITH_AS(run_to_the_end(own_examples / "csp/commstime/commstime.cfs", {{"cuont", "5"}}, replay.context),
                         doctest::Contains("\"cuont\""), RefusedInput);
}
