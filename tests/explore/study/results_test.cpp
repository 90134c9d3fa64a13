// Tests that a damaged or foreign file of results is refused, and never read as other results.

#include "explore/study/results.hpp"
#include "store/database.hpp"
#include "tests/sanitized.hpp"
#include "text/checksum.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <optional>
#include <string>

using namespace placedpar;

namespace {

const StudySource source_of_test{
    "ring.cfs", {{"ring.cfs", "host h;\n"}, {"part.inc", "val n 3;\n"}}, "{\"faults\":[]}"};

/// Returns a folder in memory if possible, since SQLite waits for disks.
std::filesystem::path quick_folder() {
    std::filesystem::path memory = "/dev/shm";
    return std::filesystem::is_directory(memory) ? memory : std::filesystem::temp_directory_path();
}

/// A file of results in its own folder, which also holds SQLite's extra files.
class ResultsFile {
public:
    ResultsFile() { std::filesystem::create_directory(folder_); }
    ~ResultsFile() { std::filesystem::remove_all(folder_); }
    ResultsFile(const ResultsFile&) = delete;
    ResultsFile& operator=(const ResultsFile&) = delete;

    std::filesystem::path path() const { return folder_ / "results.sqlite"; }
    std::string bytes() const {
        std::ifstream in(path(), std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }
    void write(const std::string& bytes) const {
        for (const char* beside : {"", "-wal", "-shm", "-journal"})
            std::filesystem::remove(path().string() + beside);
        std::ofstream(path(), std::ios::binary) << bytes;
    }

private:
    std::filesystem::path folder_ = quick_folder() / fmt::format("placedpar-results-{}", ::getpid());
};

StudyRun run_of_test(std::uint64_t seed) { return {{{"count", "7"}, {"linkspeed", "20M"}}, seed}; }

/// Writes some runs, one of them refused, in pages so small that every bit can be tried.
void make_results(const ResultsFile& file) {
    {
        StudyResults results(file.path(), source_of_test);
        results.set_measures({"time", "max(master.T_exe)"});
        for (std::uint64_t seed = 1; seed <= 3; ++seed)
            results.keep(run_of_test(seed), {.ended = "completed",
                                             .time = Time{1234567890123 * static_cast<std::int64_t>(seed)},
                                             .fingerprint = 0xfedcba9876543210 + seed,
                                             .netlist_hash = 0xabc,
                                             .figures = {{"time", {0.1 / static_cast<double>(seed), "ms"}},
                                                         {"master[0].T_exe", {-3e-300, "s"}}}});
        results.keep({{}, 4}, {.ended = "refused", .refused = "ring.cfs:1:1: error: there is no \"h\""});
    }
    store::Database(file.path()).run("PRAGMA page_size = 512; VACUUM");
}

/// Returns the whole content of the results as text.
std::string table_of(StudyResults& results) {
    std::string text = fmt::format("{} {} {}\n", results.netlist(), results.version(), results.count());
    for (const std::string& measure : results.measures())
        text += measure + "\n";
    for (const auto& [path, content] : results.source().texts)
        text += path + " " + content;
    results.for_each([&](const StudyRun& run, const StudyOutcome& outcome) {
        for (const auto& [name, value] : run.set)
            text += fmt::format("{}={} ", name, value);
        text += fmt::format("{} {} {} {:x} {:x} {}\n", run.seed, outcome.ended, outcome.time.count(),
                            outcome.fingerprint, outcome.netlist_hash, outcome.refused);
        for (const auto& [name, figure] : outcome.figures)
            text += fmt::format("{} {} {}\n", name, figure.value, figure.unit);
    });
    return text;
}

std::string table_in(const ResultsFile& file) {
    StudyResults results(file.path());
    return table_of(results);
}

/// Adds a run and removes it again; the rest of the table must not have changed.
std::string table_after_adding(const ResultsFile& file) {
    StudyResults results(file.path(), source_of_test);
    std::string before = table_of(results);
    for (std::uint64_t seed = 1; seed <= 3; ++seed)
        CHECK(results.find(run_of_test(seed)).has_value());
    results.keep(run_of_test(99), {.ended = "completed"});
    return before;
}

struct Counted {
    int refused = 0, same = 0, others = 0;
};

/// Counts how reading the table of a damaged file ends.
void count(Counted& counted, const std::string& whole, const std::function<std::string()>& table) {
    try {
        ++(table() == whole ? counted.same : counted.others);
    } catch (const UserError&) {
        ++counted.refused;
    }
}

std::string refusal_of(const ResultsFile& file) {
    try {
        table_in(file);
        return "read";
    } catch (const UserError& refused) {
        return std::string(refused.what()).substr(file.path().string().size());
    }
}

/// Checks that a good file changed by `sql` is refused, both for reading and for adding runs.
void check_refused(const std::string& sql, const std::string& why) {
    CAPTURE(sql);
    ResultsFile file;
    make_results(file);
    {
        store::Database database(file.path());
        database.run(sql);
    }
    CHECK(refusal_of(file).find(why) != std::string::npos);
    CHECK_THROWS_AS(StudyResults(file.path(), source_of_test), UserError);
}

/// Flips each bit whose number is a multiple of `one_in`. If it is a multiple of `one_written_in`, also adds runs to
/// the file.
void flip_bits(std::size_t one_in, std::size_t one_written_in) {
    ResultsFile file;
    make_results(file);
    const std::string good = file.bytes(), whole = table_in(file);
    Counted read, added;
    for (std::size_t bit = 0; bit < 8 * good.size(); ++bit) {
        if (bit % one_in != 0 && bit % one_written_in != 0)
            continue;
        CAPTURE(bit);
        std::string damaged = good;
        damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ 1 << bit % 8);
        file.write(damaged);
        count(read, whole, [&] { return table_in(file); });
        if (bit % one_written_in == 0)
            count(added, whole, [&] { return table_after_adding(file); });
    }
    MESSAGE(fmt::format("read: {} refused, {} the same; added to: {}, {}", read.refused, read.same, added.refused,
                        added.same));
    CHECK(read.others == 0);
    CHECK(added.others == 0);
    CHECK(read.refused > 0);
    CHECK(added.refused > 0);
}

} // namespace

TEST_CASE("a file of results with a flipped bit reads as before or is refused") {
    test::sanitized ? flip_bits(97, 997) : flip_bits(7, 101);
}

TEST_CASE("a file of results with a flipped bit reads as before or is refused: every bit" * doctest::skip()) {
    flip_bits(1, 1);
}

TEST_CASE("a file of results that is cut off anywhere is refused") {
    ResultsFile file;
    make_results(file);
    const std::string good = file.bytes(), whole = table_in(file);
    Counted cut;
    for (std::size_t size = 0; size < good.size(); size += test::sanitized ? 61 : 1) {
        CAPTURE(size);
        file.write(good.substr(0, size));
        count(cut, whole, [&] { return table_in(file); });
    }
    CHECK(cut.others == 0);
    CHECK(cut.refused > 9 * cut.same);
}

TEST_CASE("foreign content in a file of results is refused") {
    const std::string schema = "its tables differ from those that PlacedPar makes";
    check_refused("CREATE TRIGGER t AFTER INSERT ON runs BEGIN DELETE FROM runs; END", schema);
    check_refused("CREATE VIEW v AS SELECT * FROM runs", schema);
    check_refused("CREATE TABLE other(a)", schema);
    check_refused("CREATE INDEX i ON runs(ended)", schema);
    check_refused("ALTER TABLE runs ADD COLUMN more TEXT", schema);
    check_refused("ALTER TABLE runs RENAME COLUMN ended TO finished", schema);
    check_refused("PRAGMA user_version = 1",
                  "from an earlier version of PlacedPar; this version reads format 2: "
                  "use the other version to report its runs, or sweep again with another --results");
    check_refused("PRAGMA user_version = 3", "from a later version of PlacedPar; this version reads format 2");
}

TEST_CASE("changed, exchanged, removed or added rows are refused") {
    check_refused("UPDATE runs SET ended = 'deadlock' WHERE seed = 2", "row 2 of table runs");
    check_refused("UPDATE runs SET figures = replace(figures, ',', '-')", "row 1 of table runs");
    check_refused("UPDATE runs SET seed = 9 WHERE seed = 3", "row 3 of table runs");
    check_refused("UPDATE runs SET seed = -seed WHERE seed < 3; UPDATE runs SET seed = 3 + seed WHERE seed < 0",
                  "of table runs");
    check_refused("UPDATE runs SET settings = '{}' WHERE seed = 1", "of table runs");
    check_refused("DELETE FROM runs WHERE seed = 3", "table runs has 3 rows, but should have 4");
    check_refused("INSERT INTO runs SELECT settings, 12, ended, time_ps, fingerprint, netlist_hash, version, refused, "
                  "figures, checksum FROM runs WHERE seed = 1",
                  "of table runs");
    check_refused("DELETE FROM study", "table study has no row");
    check_refused("DELETE FROM texts WHERE place = 1", "or a row of table texts");
    check_refused("UPDATE texts SET place = 7 - place", "or a row of table texts");
    check_refused("UPDATE study SET measures = '[]'", "the row of table study");
}

TEST_CASE("a row that is not a run is refused even with a correct checksum") {
    for (const char* figures : {"", "{", "[]", "{\"a\":[1-2,\"s\"]}", "{\"a\":[1]}", "{\"a\":[1e999,\"s\"]}",
                                "{\"a\":[\"1\",\"s\"]}", "{\"a\":[1,2]}", "{\"a\":[-,\"s\"]}", "{\"a\":[[3],\"s\"]}"}) {
        CAPTURE(figures);
        ResultsFile file;
        make_results(file);
        const std::int64_t checksum =
            checksum_of("run", "{}", "4", "completed", "0", "00", "00", "v", "", std::string(figures));
        {
            store::Database database(file.path());
            store::Statement(
                database, "UPDATE runs SET ended = 'completed', time_ps = 0, fingerprint = '00', netlist_hash = '00', "
                          "version = 'v', refused = '', figures = ?1, checksum = ?2 WHERE seed = 4")
                .run(std::string(figures), checksum);
            std::int64_t sum = 0;
            store::Statement rows(database, "SELECT checksum FROM runs");
            while (rows.step())
                sum ^= rows.integer(0);
            store::Statement study(database, "SELECT netlist, options, version, measures FROM study");
            REQUIRE(study.step());
            std::string texts;
            for (const auto& [path, text] : source_of_test.texts)
                texts += fmt::format("{:016x}", static_cast<std::uint64_t>(checksum_of(path, text)));
            const std::int64_t head = checksum_of(study.text(0), study.text(1), study.text(2), study.text(3),
                                                  std::string("4"), std::to_string(sum), texts);
            study.reset();
            store::Statement(database, "UPDATE study SET sum = ?1, checksum = ?2").run(sum, head);
        }
        CHECK(refusal_of(file).find("PlacedPar did not write this row") != std::string::npos);
    }
}
