// Compares printed programs with what was read: by the printed form of what is read from it, and word by word with
// the source. PLACEDPAR_T4 and PLACEDPAR_D7205 name folders with genuine programs.

#include "occam/language/lines.hpp"
#include "occam/language/print.hpp"
#include "tests/occam/language/read_text.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cstdlib>
#include <fstream>

using namespace placedpar;

namespace {

/// Returns one spelling of words that the tree does not tell apart.
std::string spelling(const occam::Word& word) {
    static constexpr std::array<std::array<const char*, 2>, 4> same = {
        {{"BITAND", "/\\"}, {"BITOR", "\\/"}, {"BITNOT", "~"}, {"REM", "\\"}}};
    for (const auto& [old, shown] : same)
        if (word.text == old)
            return shown;
    if (word.kind == occam::WordKind::string || word.kind == occam::WordKind::character)
        return "\"" + (word.text.starts_with("\"*l") ? "l" + word.bytes.substr(1) : word.bytes);
    if (word.kind == occam::WordKind::integer) {
        const bool is_hexadecimal = word.text.starts_with('#');
        return std::to_string(
            std::stoull(std::string(word.text.substr(is_hexadecimal ? 1 : 0)), nullptr, is_hexadecimal ? 16 : 10));
    }
    return std::string(word.text);
}

/// Returns the words of a text with what it includes, without parentheses, OF, and ends of lines.
std::vector<std::string> words_of(const std::string& text, const std::string& path) {
    occam::Program program;
    const occam::ParseOptions options{
        .folders = {}, .built_in = [](const auto&) { return std::string(); }, .defined = {}};
    Reporter reporter;
    occam::Reading reading{.program = program, .options = options, .reporter = reporter};
    reading.open.push_back({path, {}});
    occam::Lines lines(reading, add_file(reading, std::make_shared<const SourceFile>(path, text), {}));
    std::vector<std::string> words;
    for (auto line = lines.next(); !line.is_end; line = lines.next())
        for (const occam::Word& word : line.words)
            if (word.kind != occam::WordKind::end && !word.is("(") && !word.is(")") && word.text != "OF")
                words.push_back(spelling(word));
    return words;
}

/// Programs of others: returns how many were read without an error.
std::size_t check_printed(const std::vector<std::filesystem::path>& files) {
    std::size_t good = 0;
    for (const auto& file : files) {
        CAPTURE(file.string());
        const std::string text = test::whole_file(file);
        const auto read = test::read_text(text, file.string(), {}, true);
        if (read.failed)
            continue;
        const std::string printed = occam::print(*read.parsed.program);
        const auto again = test::read_text(printed, file.string(), {}, true);
        REQUIRE_MESSAGE(!again.failed, again.messages);
        CHECK(occam::print(*again.parsed.program) == printed);
        ++good;
    }
    return good;
}

} // namespace

TEST_CASE("a printed program has the words of its source") {
    const auto files = test::occam_programs();
    CHECK(check_printed(files) == files.size());
    for (const auto& file : files) {
        CAPTURE(file.string());
        const std::string text = test::whole_file(file);
        const auto read = test::read_text(text, file.string());
        CHECK(read.messages == "");
        const std::string printed = occam::print(*read.parsed.program);
        const bool has_other_forms = file.stem() == "constructs"; // fields, CASE behind a name, a minus of a string
        if (!has_other_forms)
            CHECK(words_of(printed, file.string()) == words_of(text, file.string()));
        else {
            const auto expected = std::filesystem::path(file).replace_extension(".txt");
            if (std::getenv("PLACEDPAR_ACCEPT") != nullptr)
                std::ofstream(expected, std::ios::binary) << printed;
            CHECK(printed == test::whole_file(expected));
        }
    }
}

TEST_CASE("programs of the time are read and printed") {
    std::size_t good = 0;
    for (const char* variable : {"PLACEDPAR_T4", "PLACEDPAR_D7205"})
        if (const char* folder = std::getenv(variable))
            good += check_printed(test::occam_files(folder, ".occ"));
        else
            MESSAGE(variable << " names no folder");
    if (std::getenv("PLACEDPAR_T4") && std::getenv("PLACEDPAR_D7205"))
        CHECK(good >= 200);
}
