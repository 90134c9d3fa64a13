#include "text/load_source.hpp"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>

using namespace placedpar;

namespace {

/// Returns the only problem as "2:6: message".
std::string problem_of(const LoadedSource& loaded) {
    REQUIRE(loaded.problems.size() == 1);
    REQUIRE(loaded.file);
    const Diagnostic& problem = loaded.problems[0];
    CHECK(problem.severity == Severity::error);
    CHECK(problem.location.file == loaded.file);
    return std::to_string(problem.location.line) + ":" + std::to_string(problem.location.column) + ": " +
           problem.message;
}

} // namespace

TEST_CASE("a source has its lines") {
    SourceFile file("a.txt", "one\r\ntwo\n\nfour");
    CHECK(file.path() == "a.txt");
    CHECK(file.line(1) == "one");
    CHECK(file.line(2) == "two");
    CHECK(file.line(3).empty());
    CHECK(file.line(4) == "four");
    CHECK(file.line(0).empty());
    CHECK(file.line(5).empty());
}

TEST_CASE("a location is printed as file, line and column") {
    auto file = std::make_shared<SourceFile>("a.txt", "one");
    CHECK(Location{file, 1, 3}.text() == "a.txt:1:3");
    CHECK(Location{file, 0, 0}.text() == "a.txt");
    CHECK(Location{}.text().empty());
}

TEST_CASE("content that is not text is refused with its place and can be shown") {
    CHECK(problem_of(check_source("a", std::string("a;\n\tval \0 x", 11))) ==
          "2:6: this is a binary file, not text: it contains the byte 0x00");
    CHECK(problem_of(check_source("a", "\x7f"
                                       "ELF")) == "1:1: this is a binary file, not text: it contains the byte 0x7f");
    CHECK(problem_of(check_source("a", "short\n" + std::string(longest_source_line + 1, 'x'))) ==
          "2:10001: the line is too long: it has 10001 bytes, but at most 10000 bytes are allowed");
    CHECK(problem_of(check_source("a", std::string(largest_source_bytes + 1, '\n'))) ==
          "0:0: the file is too large: at most 16777216 bytes are allowed");
}

TEST_CASE("UTF-8 and ISO text is accepted") {
    LoadedSource loaded = check_source("a", "\xef\xbb\xbf"
                                            "Stra\xdf"
                                            "e\t1\r\n\f" +
                                                std::string(longest_source_line - 1, 'x'));
    CHECK(loaded.problems.empty());
    CHECK(loaded.file->line(1) == "Stra\xdf"
                                  "e\t1");
    CHECK(check_source("a", "").problems.empty());
}

TEST_CASE("an escape sequence does not make a text a binary file") {
    CHECK(problem_of(check_source("a", "one\ntwo \x1b[31mred")) ==
          "2:5: the control character 0x1b is not allowed in a text: remove it");
    CHECK(problem_of(check_source("a", std::string("\x1b[31m\0", 6))) ==
          "1:1: this is a binary file, not text: it contains the byte 0x1b");
}

TEST_CASE("Ctrl-Z ends a text, and anything may follow it") {
    LoadedSource loaded = check_source("a", std::string("one\r\n\x1a\0\x01", 8));
    CHECK(loaded.problems.empty());
    CHECK(loaded.file->text() == "one\r\n");
}

TEST_CASE("a carriage return does not count in a line's length") {
    CHECK(check_source("a", std::string(longest_source_line, 'x') + "\r\n").problems.empty());
}

TEST_CASE("a file that cannot be read is a problem of the whole file") {
    auto folder = std::filesystem::temp_directory_path();
    CHECK(problem_of(load_source(folder / "placedpar_no_such_file")) == "0:0: this file does not exist");
    CHECK(problem_of(load_source(folder)) == "0:0: this is a directory, not a file");
    CHECK(problem_of(load_source("/dev/null")) == "0:0: this is neither a file nor a pipe");
}

TEST_CASE("a source takes only the memory of its text") {
    auto path = std::filesystem::temp_directory_path() / "placedpar_small_source_test.txt";
    std::ofstream(path) << std::string(800, 'x');
    LoadedSource loaded = load_source(path);
    std::filesystem::remove(path);
    CHECK(loaded.problems.empty());
    CHECK(loaded.file->text() == std::string(800, 'x'));
    CHECK(loaded.file->text().capacity() < 10'000);
}

TEST_CASE("UTF-16 and lines that end in carriage returns only are refused by name") {
    using namespace std::string_literals;
    constexpr const char* wide =
        "0:0: the file is UTF-16, expected UTF-8 or ASCII: iconv -f UTF-16 -t UTF-8 FILE > NEW "
        "converts it";
    CHECK(problem_of(check_source("a.csv", "\xff\xfet\0"s)) == wide);
    CHECK(problem_of(check_source("a.csv", "\xfe\xff\0t"s)) == wide);
    CHECK(problem_of(check_source("a.csv", "t\0i\0m\0e\0"s)) == wide);
    CHECK(problem_of(check_source("a.csv", "\0t\0i\0m\0e"s)) == wide);
    CHECK(problem_of(check_source("a.csv", "\0\0\0\0\0\0\0\0"s)).find("binary file") != std::string::npos);
    std::string old;
    while (old.size() < 2 * longest_source_line)
        old += "0.02,1\r";
    CHECK(problem_of(check_source("a.csv", old)) ==
          "1:7: the lines end in carriage returns only, not in LF or CR LF: tr "
          "'\\r' '\\n' < FILE > NEW converts the file");
}
