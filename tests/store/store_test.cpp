#include "store/database.hpp"
#include "store/file_lock.hpp"

#include <doctest/doctest.h>

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>

using namespace placedpar;

namespace {

/// A temporary file for one test.
class ScratchFile {
public:
    ScratchFile() : path_(std::filesystem::temp_directory_path() / ("placedpar-store-" + std::to_string(::getpid()))) {
        std::filesystem::remove(path_);
    }
    ~ScratchFile() { std::filesystem::remove(path_); }
    ScratchFile(const ScratchFile&) = delete;
    ScratchFile& operator=(const ScratchFile&) = delete;
    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

} // namespace

TEST_CASE("bound values are read back exactly") {
    ScratchFile file;
    store::Database database(file.path());
    database.run("CREATE TABLE t(a INTEGER, b REAL, c TEXT, d REAL)");
    std::string text("zero \0 and more", 15);
    store::Statement(database, "INSERT INTO t VALUES(?1, ?2, ?3, ?4)")
        .run(std::numeric_limits<std::uint64_t>::max(), 0.1, text, std::optional<double>());
    store::Statement row(database, "SELECT a, b, c, d FROM t");
    REQUIRE(row.step());
    CHECK(static_cast<std::uint64_t>(row.integer(0)) == std::numeric_limits<std::uint64_t>::max());
    CHECK(row.number(1) == 0.1);
    CHECK(row.text(2) == text);
    CHECK_FALSE(row.optional_number(3));
    CHECK_FALSE(row.step());
}

TEST_CASE("a corrupt file is reported as damage, a wrong statement is not") {
    ScratchFile file;
    std::ofstream(file.path()) << std::string(5000, 'x');
    store::Database database(file.path());
    try {
        database.run("CREATE TABLE t(x)");
        FAIL("it is no database");
    } catch (const store::DatabaseError& error) {
        CHECK(error.damage());
    }
    store::Database other(":memory:");
    try {
        other.run("SELECT nothing FROM nowhere");
        FAIL("there is no such table");
    } catch (const store::DatabaseError& error) {
        CHECK_FALSE(error.damage());
    }
}

TEST_CASE("a second lock is refused with the name of the program that uses the file") {
    ScratchFile file;
    std::ofstream(file.path()) << "content";
    std::optional<store::FileLock> first(std::in_place, file.path(), "the file", "test");
    CHECK(first->beginning(4) == "cont");
    CHECK(first->size() == 7);
    CHECK_THROWS_WITH(store::FileLock(file.path(), "the file", "test"), "the file: another test is using the file");
    first.reset();
    CHECK_NOTHROW(store::FileLock(file.path(), "the file", "test"));
}
