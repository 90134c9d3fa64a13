// Tests that settings with the same meaning get one spelling.

#include "explore/study/canonical_settings.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace placedpar;

namespace {

void keep_run(StudyResults& results, const std::string& slaves, std::uint64_t seed, double rate) {
    results.keep({{{"slaves", slaves}}, seed}, {.ended = "completed", .figures = {{"rate", {rate, ""}}}});
}

/// Returns each run as "slaves seed: rate".
std::vector<std::string> told_by(CanonicalSettings& spellings) {
    std::vector<std::string> told;
    spellings.for_each([&](const StudyRun& run, const StudyOutcome& outcome) {
        told.push_back(run.set.at("slaves") + " " + std::to_string(run.seed) + ": " +
                       std::to_string(static_cast<int>(outcome.figures.at("rate").value)));
    });
    return told;
}

using Told = std::vector<std::string>;

} // namespace

TEST_CASE("settings are spelled as in the study, otherwise as in the first run") {
    StudyResults results(StudySource{});
    keep_run(results, "4+4", 1, 1);
    Study study;
    study.products = {{.axes = {read_axis("slaves=8,9")}}};
    CHECK(CanonicalSettings(results, &study).of({{"slaves", "8.0"}}) == Overrides{{"slaves", "8"}});
    CHECK(CanonicalSettings(results, nullptr).of({{"slaves", "8.0"}}) == Overrides{{"slaves", "4+4"}});
    CHECK(CanonicalSettings(results, nullptr).of({{"slaves", "7.0"}}) == Overrides{{"slaves", "7.0"}});
    CHECK(CanonicalSettings(results, nullptr).of({{"clock", "8.0"}}) == Overrides{{"clock", "8.0"}}); // no such val
}

TEST_CASE("if runs have equal settings, only the run in the study's spelling is passed on") {
    StudyResults results(StudySource{});
    keep_run(results, "8", 1, 1);
    keep_run(results, "8.0", 1, 2);
    keep_run(results, "8.0", 2, 3);
    Study study;
    study.products = {{.axes = {read_axis("slaves=8")}}};
    CanonicalSettings by_study(results, &study);
    CHECK(told_by(by_study) == Told{"8 1: 1", "8 2: 3"});
    study.products = {{.axes = {read_axis("slaves=8.0")}}};
    CanonicalSettings by_other(results, &study);
    CHECK(told_by(by_other) == Told{"8.0 1: 2", "8.0 2: 3"});
}
