#include "netlist/run_report.hpp"

#include <doctest/doctest.h>

namespace placedpar {
namespace {

RunOutcome outcome_of(Ending ending, bool failed, bool halted) {
    RunReport report;
    report.result.ending = ending;
    report.programs.resize(2);
    report.programs.back().failed = failed;
    report.programs.back().halted = halted;
    return report.outcome();
}

} // namespace

TEST_CASE("without a failed program, the outcome of a run is its ending") {
    CHECK(outcome_of(Ending::completed, false, false) == RunOutcome::completed);
    CHECK(outcome_of(Ending::time_limit, false, false) == RunOutcome::time_limit);
    CHECK(outcome_of(Ending::stuck, false, false) == RunOutcome::deadlock);
    CHECK(outcome_of(Ending::interrupted, false, false) == RunOutcome::interrupted);
}

TEST_CASE("a failed program counts unless others wait for ever; a halted processor counts even then") {
    for (const Ending ending : {Ending::completed, Ending::time_limit, Ending::stuck}) {
        CHECK(outcome_of(ending, true, true) == RunOutcome::halted);
        CHECK(outcome_of(ending, true, false) == (ending == Ending::stuck ? RunOutcome::deadlock : RunOutcome::failed));
    }
    CHECK(outcome_of(Ending::interrupted, true, true) == RunOutcome::interrupted);
}

} // namespace placedpar
