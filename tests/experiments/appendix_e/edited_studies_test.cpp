// Tests replays of studies that a user has edited: wrong figures miss, and missing rows are refused by name.

#include "tests/experiments/kit/replay_in_memory.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>

using namespace placedpar;
namespace fs = std::filesystem;

namespace {

/// A copy of the thesis's examples in which a text of one file is replaced. The copy is deleted at the end.
class EditedExamples {
public:
    EditedExamples() {
        fs::create_directories(folder_);
        fs::copy(fs::path(PLACEDPAR_SOURCE_DIR) / "examples/thesis", folder_ / "thesis", fs::copy_options::recursive);
    }
    ~EditedExamples() { fs::remove_all(folder_); }
    EditedExamples(const EditedExamples&) = delete;
    EditedExamples& operator=(const EditedExamples&) = delete;

    const fs::path& folder() const { return folder_; }
    /// Replaces the first place of the old text.
    void edit(const std::string& file, std::string_view old, std::string_view replacement) const {
        std::ifstream in(folder_ / file);
        std::string text{std::istreambuf_iterator<char>(in), {}};
        const std::size_t at = text.find(old);
        REQUIRE(at != text.npos);
        std::ofstream(folder_ / file) << text.replace(at, old.size(), replacement);
    }

private:
    static inline int made_ = 0; ///< number of copies made so far
    fs::path folder_ = fs::temp_directory_path() / fmt::format("placedpar-edited-{}-{}", ::getpid(), ++made_);
};

/// Replays of edited examples. Runs that an edit does not concern are made once for all of them.
class EditedReplay {
public:
    explicit EditedReplay(std::string_view experiment)
        : experiment_(*std::ranges::find(experiments(), experiment, &Experiment::name)) {}

    Replay run(const EditedExamples& examples, bool printed = false) {
        memory_.context.examples = examples.folder();
        memory_.context.printed = printed;
        return experiment_.run(memory_.context);
    }

private:
    const Experiment& experiment_;
    test::ReplayInMemory memory_{0};
};

/// Returns the replay of Table E.1 that the tests below share.
EditedReplay& table_e1() {
    static EditedReplay replay("table-e1");
    return replay;
}

constexpr const char* table_e1_file = "thesis/table-e1/table-e1.toml";
constexpr const char* table_e2_file = "thesis/figure-e2/table-e2.toml";

} // namespace

TEST_CASE("Table E.1 misses if a figure of the thesis is replaced by one that is 4 % greater") {
    const EditedExamples right, wrong;
    CHECK(table_e1().run(right).within_tolerance());
    wrong.edit(table_e1_file, "known = [97.0,", "known = [101.0,");
    const Replay missed = table_e1().run(wrong);
    CHECK_FALSE(missed.within_tolerance());
    const Comparison& table = missed.comparisons.at(0);
    CHECK(std::ranges::count_if(table.cells, [](const Cell& cell) { return !cell.within_tolerance(); }) == 1);
}

TEST_CASE("Table E.1 needs the row and the known figures from which the communication is computed") {
    const EditedExamples no_row, no_figure;
    no_row.edit(table_e1_file, "{name = \"C_time2\"", "{name = \"C_time\"");
    CHECK_THROWS_WITH_AS(table_e1().run(no_row),
                         doctest::Contains("has no known value in row \"C_time2\", column \"1 slave\""), UserError);
    no_figure.edit(table_e1_file, "known = [0.0, 0.6,", "known = [0.0, nan,");
    CHECK_THROWS_WITH_AS(table_e1().run(no_figure), doctest::Contains("table-e1.toml: the table \"120 individuals"),
                         UserError);
}

TEST_CASE("the constants of Table E.1 are those of the edited netlist") {
    const EditedExamples edited;
    edited.edit("thesis/workload.inc", "measurement_bytes 148", "measurement_bytes 152");
    CHECK(table_e1().run(edited).constants.find("; 152 bytes of measurements") != std::string::npos);
}

TEST_CASE("Table E.2 as printed is judged only if that is asked for, and then misses") {
    EditedReplay replay("table-e2");
    const EditedExamples examples;
    CHECK(replay.run(examples).within_tolerance());
    CHECK_FALSE(replay.run(examples, true).within_tolerance());
    const EditedExamples renamed;
    renamed.edit(table_e2_file, "name = \"as the thesis prints it\"", "name = \"as printed\"");
    CHECK_THROWS_WITH_AS(
        replay.run(renamed),
        doctest::Contains("the replay needs a table \"as the thesis prints it\", but the study has only "), UserError);
}
