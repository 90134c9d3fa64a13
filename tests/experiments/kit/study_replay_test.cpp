// Tests a replay made from a study with tables: its content, and refusals of an edited file.

#include "experiments/kit/study_replay.hpp"

#include "experiments/kit/experiment_runs.hpp"
#include "runtime/fingerprint.hpp"
#include "tests/experiments/kit/replay_in_memory.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

using namespace placedpar;

namespace {

/// A folder of examples with a study of one of the project's netlists, deleted at the end.
class EditedStudy {
public:
    explicit EditedStudy(const std::string& text, const std::string& netlist = "csp/commstime/commstime.cfs") {
        std::filesystem::create_directories(folder_);
        std::ofstream(folder_ / "edited.toml")
            << fmt::format("netlist = \"{}/examples/{}\"\n{}", PLACEDPAR_SOURCE_DIR, netlist, text);
    }
    ~EditedStudy() { std::filesystem::remove_all(folder_); }
    EditedStudy(const EditedStudy&) = delete;
    EditedStudy& operator=(const EditedStudy&) = delete;

    const std::filesystem::path& folder() const { return folder_; }
    std::string path() const { return (folder_ / "edited.toml").string(); }

private:
    std::filesystem::path folder_ =
        std::filesystem::temp_directory_path() / fmt::format("placedpar-study-replay-{}", ::getpid());
};

const std::string of_two_counts = R"(measure = "time"
notes = "by the stopwatch\n"
[[table]]
name = "packets"
against = "clock"
columns = [{name = "10 packets", set = {count = 10}}, {name = "20 packets", set = {count = 20}}]
rows = [{name = "time", figure = "time", unit = "ms", decimals = 4, known = [1, nan], tolerance = "1 %"}]
)";

/// Checks that a replay of this study is refused with this message, after the file's name.
void check_refused(const std::string& text, const std::string& why) {
    const EditedStudy study(text);
    test::ReplayInMemory replay(0, study.folder());
    CHECK_THROWS_WITH_AS(StudyReplay(replay.context, "edited.toml").replay(), (study.path() + ": " + why).c_str(),
                         UserError);
}

} // namespace

TEST_CASE("a replay has the tables and notes of its study, with the figures of its runs") {
    const EditedStudy file(of_two_counts);
    test::ReplayInMemory in_memory(0, file.folder());
    const StudyReplay study(in_memory.context, "edited.toml");
    Replay replay = study.replay();
    CHECK(in_memory.told.front() == "0 of 2 runs");
    CHECK(replay.constants == "by the stopwatch\n");
    const Comparison& table = study.table(replay, "packets");
    CHECK(&table == &replay.comparisons.at(0));
    CHECK(table.against == "clock");
    REQUIRE(table.cells.size() == 2);
    CHECK(table.cells[0].simulated == study.measured({{"count", "10"}}, "time"));
    CHECK(table.cells[1].simulated == study.measured({{"count", "20"}}, "time"));
    CHECK(table.cells[0].simulated < table.cells[1].simulated);
    CHECK_FALSE(table.cells[0].within_tolerance()); // about .1 ms
    CHECK_FALSE(replay.within_tolerance());
}

TEST_CASE("a replay's fingerprint covers all its runs in order") {
    const EditedStudy file(of_two_counts);
    test::ReplayInMemory in_memory(0, file.folder());
    const StudyReplay study(in_memory.context, "edited.toml");
    Fingerprint both;
    for (const char* count : {"10", "20"})
        both.mix(study.fingerprint({{"count", count}}));
    CHECK(study.replay().fingerprint == both.value());
}

TEST_CASE("earlier runs are not repeated") {
    const EditedStudy file(of_two_counts);
    test::ReplayInMemory in_memory(0, file.folder());
    const StudyReplay first(in_memory.context, "edited.toml");
    in_memory.told.clear();
    const StudyReplay again(in_memory.context, "edited.toml");
    CHECK(in_memory.told.front() == "0 of 0 runs");
    CHECK(again.replay().fingerprint == first.replay().fingerprint);
}

TEST_CASE("the number in a name is the first one, with its fraction") {
    const EditedStudy file(of_two_counts);
    test::ReplayInMemory in_memory(0, file.folder());
    const StudyReplay study(in_memory.context, "edited.toml");
    CHECK(study.number_in("tree of 12 slaves") == 12);
    CHECK(study.number_in("0.25 of 3") == 0.25);
    CHECK(study.number_in("7") == 7);
    for (const char* name : {"", "no slaves", "1.2.3 slaves"})
        CHECK_THROWS_WITH_AS(study.number_in(name), doctest::Contains("the replay needs a number in the name \""),
                             UserError);
}

TEST_CASE("a study without tables, with seeds of its own, or with figures that no run can have is refused") {
    check_refused("measure = \"time\"\n[set]\ncount = 3\n", "the study has no [[table]], but a replay needs one");
    for (const char* seeds : {"seeds = 2\n", "first_seed = 7\n"})
        check_refused(seeds + of_two_counts,
                      "the seed of a replay comes from --seed: remove seeds and first_seed from the study");
    check_refused("measure = [\"time\", \"consumer.rte\"]\n" + of_two_counts.substr(of_two_counts.find('\n') + 1),
                  "unknown measure \"consumer.rte\"; did you mean \"consumer.rate\"?");
}

TEST_CASE("a replay refuses a study that lacks a run or figure to be shown") {
    const EditedStudy file(of_two_counts);
    test::ReplayInMemory in_memory(0, file.folder());
    const StudyReplay study(in_memory.context, "edited.toml");
    Replay replay = study.replay();
    CHECK_THROWS_WITH_AS(
        study.table(replay, "parcels"),
        (file.path() + ": the replay needs a table \"parcels\", but the study has only \"packets\"").c_str(),
        UserError);
    CHECK_THROWS_WITH_AS(study.measured({{"count", "30"}}, "time"),
                         (file.path() + ": the replay needs a run with count = 30, which the study lacks").c_str(),
                         UserError);
    CHECK_THROWS_WITH_AS(study.measured({{"count", "10"}}, "tim"),
                         doctest::Contains("unknown measure \"tim\"; did you mean \"time\"?"), UserError);
}

TEST_CASE("a replay whose machine deadlocks is refused") {
    const std::string table = "[[table]]\nname = \"ring\"\ncolumns = [{name = \"all\", set = {n = 3}}]\n"
                              "rows = [{name = \"time\", figure = \"time\"}]\n";
    const EditedStudy stuck("measure = \"time\"\n" + table, "csp/deadlock/ring.cfs");
    test::ReplayInMemory in_memory(0, stuck.folder());
    CHECK_THROWS_WITH_AS(StudyReplay(in_memory.context, "edited.toml").replay(),
                         doctest::Contains("did not complete: placedpar run shows where it stopped"), UnfinishedRun);
}

TEST_CASE("an interrupted replay has no table") {
    const EditedStudy file(of_two_counts);
    test::ReplayInMemory in_memory(0, file.folder());
    in_memory.interruption.request();
    CHECK_THROWS_WITH_AS(StudyReplay(in_memory.context, "edited.toml"),
                         "interrupted: the experiment is incomplete, so no table or plot was made", UnfinishedRun);
}
