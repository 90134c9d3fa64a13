#include "netlist/language/occam.hpp"

#include "netlist/language/characters.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace placedpar {

namespace {

std::string_view without_blanks(std::string_view line) {
    auto first = line.find_first_not_of(" \t");
    return first == line.npos ? "" : line.substr(first, line.find_last_not_of(" \t") + 1 - first);
}

bool begins_as_occam(std::string_view line) {
    static constexpr std::array<std::string_view, 13> beginnings{
        "PLACED PAR", "#USE ", "#SC ",  "CHAN OF ", "PROTOCOL ", "PROC ",  "VAL ",
        "NODE ",      "ARC ",  "EDGE ", "NETWORK ", "MAPPING ",  "CONFIG "};
    return std::ranges::any_of(beginnings, [&](auto beginning) { return line.starts_with(beginning); });
}

bool is_word_of_occam(std::string_view line) {
    static constexpr std::array<std::string_view, 5> words{"SEQ", "PAR", "CONFIG", "NETWORK", "MAPPING"};
    return std::ranges::find(words, line) != words.end();
}

/// `PROCESSOR 0 T8`
bool is_processor(std::string_view line) {
    constexpr std::string_view word = "PROCESSOR ";
    auto number = line.starts_with(word) ? without_blanks(line.substr(word.size())) : "";
    return !number.empty() && is_digit(number.front());
}

bool is_occam(std::string_view line) { return begins_as_occam(line) || is_word_of_occam(line) || is_processor(line); }

/// Whether a C comment is open behind the line.
bool comment_goes_on(std::string_view line, bool open) {
    auto start = line.rfind("/*"), end = line.rfind("*/");
    if (start == line.npos)
        return open && end == line.npos;
    return end == line.npos || end < start;
}

} // namespace

std::optional<Location> occam_in(const std::shared_ptr<const SourceFile>& file) {
    auto lines = static_cast<std::size_t>(std::ranges::count(file->text(), '\n')) + 1;
    bool in_comment = false;
    for (std::size_t number = 1; number <= lines; ++number) {
        auto line = file->line(number), words = without_blanks(line);
        if (!in_comment && is_occam(words))
            return Location{file, number, static_cast<std::size_t>(words.data() - line.data()) + 1};
        in_comment = comment_goes_on(line, in_comment);
    }
    return std::nullopt;
}

} // namespace placedpar
