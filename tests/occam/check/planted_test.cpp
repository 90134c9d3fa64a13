// Plants single faults in good programs: the messages stay near the fault, and are few.

#include "occam/check/check.hpp"
#include "occam/library/library.hpp"
#include "tests/occam/language/read_text.hpp"
#include "tests/seeds.hpp"
#include "text/diagnostic.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <random>

using namespace placedpar;

namespace {

struct PlantedFault {
    std::string text;
    std::size_t line = 1;
};

struct TextWord {
    std::size_t start = 0, size = 0;
};

bool is_in_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.'; }

std::vector<TextWord> text_words_of(const std::string& text) {
    std::vector<TextWord> words;
    for (std::size_t i = 0; i < text.size(); ++i)
        if (is_in_name(text[i]) && !words.empty() && words.back().start + words.back().size == i &&
            is_in_name(text[i - 1]))
            ++words.back().size;
        else if (text[i] != ' ' && text[i] != '\n')
            words.push_back({i, 1});
    return words;
}

constexpr std::array<std::string_view, 7> fault_names = {
    "removed word", "doubled word", "replaced word", "indented line", "replaced name", "removed line", "doubled line"};

/// Returns a random word that `is_wanted`.
template <class IsWanted>
TextWord a_word(const std::string& text, std::mt19937_64& random, IsWanted is_wanted) {
    std::vector<TextWord> words = text_words_of(text);
    std::erase_if(words, [&](const TextWord& each) { return !is_wanted(text[each.start]); });
    return words[random() % words.size()];
}

PlantedFault planted(std::string text, std::size_t kind, std::mt19937_64& random) {
    const auto is_letter = [](char c) { return std::islower(static_cast<unsigned char>(c)) != 0; };
    const auto is_any = [](char) { return true; };
    const TextWord one = kind == 4 ? a_word(text, random, is_letter) : a_word(text, random, is_any);
    const TextWord other = kind == 4 ? a_word(text, random, is_letter) : a_word(text, random, is_any);
    const auto line = static_cast<std::size_t>(
        std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(one.start), '\n') + 1);
    const std::string own = text.substr(one.start, one.size);
    const std::size_t line_start = text.rfind('\n', one.start) + 1, line_end = text.find('\n', one.start) + 1;
    switch (kind) {
    case 0: text.erase(one.start, one.size); break;
    case 1: text.insert(one.start, own + " "); break;
    case 2:
    case 4: text.replace(one.start, one.size, text.substr(other.start, other.size)); break;
    case 3: text.insert(line_start, 1 + random() % 3, ' '); break;
    case 5: text.erase(line_start, line_end - line_start); break;
    default: text.insert(line_start, text.substr(line_start, line_end - line_start));
    }
    return {std::move(text), line};
}

/// Returns the lines of the errors among messages.
std::vector<std::size_t> error_lines(const std::string& messages) {
    std::vector<std::size_t> lines;
    for (std::size_t at = 0; (at = messages.find(": error: ", at)) != std::string::npos; ++at) {
        const auto start = messages.rfind("text.occ:", at);
        lines.push_back(start == std::string::npos ? 0 : std::stoul(messages.substr(start + 9)));
    }
    return lines;
}

std::string messages_of_check(const std::string& text) {
    Reporter reporter;
    const auto file = std::make_shared<SourceFile>("text.occ", text);
    const occam::Parsed parsed =
        occam::parse(file, {.folders = {}, .built_in = occam::library_text, .defined = {}}, reporter);
    if (!reporter.failed())
        occam::check(*parsed.program, parsed.options, reporter);
    return reporter.failed() ? render(reporter.take()) : "";
}

std::vector<std::filesystem::path> good_programs() {
    std::vector<std::filesystem::path> files;
    for (const char* folder :
         {"tests/occam/programs", "tests/occam/code/programs", "examples/occam", "docs/occam-course/answers"})
        for (const auto& file : test::occam_files(std::filesystem::path(PLACEDPAR_SOURCE_DIR) / folder, ".occ"))
            if (messages_of_check(test::whole_file(file)).empty())
                files.push_back(file);
    return files;
}

} // namespace

TEST_CASE("a single fault has few messages, and one of them is near it") {
    struct Count {
        std::size_t refused = 0, near = 0, few = 0;
    };
    std::array<Count, fault_names.size()> counts;
    for (const auto& file : good_programs())
        for (const auto seed : test::seeds(14)) {
            INFO(test::replay(seed), " ", file.string());
            std::mt19937_64 random(seed);
            const std::size_t kind = seed % fault_names.size();
            const PlantedFault fault = planted(test::whole_file(file), kind, random);
            const auto lines = error_lines(messages_of_check(fault.text));
            if (lines.empty()) // the program may be good still
                continue;
            ++counts[kind].refused;
            counts[kind].near += std::ranges::any_of(
                lines, [&](std::size_t line) { return line + 2 >= fault.line && line <= fault.line + 2; });
            counts[kind].few += lines.size() <= 3;
        }
    for (std::size_t kind = 0; kind < counts.size() && test::all_seeds(); ++kind) {
        const auto& [refused, near, few] = counts[kind];
        CAPTURE(fault_names[kind]);
        MESSAGE(fault_names[kind], ": ", refused, " refused, ", near, " near, ", few, " few");
        CHECK(refused >= 26);
        // Names that have lost their declaration are reported where they are used.
        CHECK(near * 100 >= refused * (kind == 4 || kind == 5 ? 70 : 97));
        CHECK(few * 100 >= refused * 95);
    }
}
