// Plants single faults in good programs: the messages stay near the fault, and are few.

#include "tests/occam/language/read_text.hpp"
#include "tests/seeds.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cctype>
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

std::vector<TextWord> text_words_of(const std::string& text) {
    std::vector<TextWord> words;
    const auto is_in_name = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.'; };
    for (std::size_t i = 0; i < text.size(); ++i)
        if (is_in_name(text[i]) && !words.empty() && words.back().start + words.back().size == i &&
            is_in_name(text[i - 1]))
            ++words.back().size;
        else if (text[i] != ' ' && text[i] != '\n')
            words.push_back({i, 1});
    return words;
}

/// Removes, doubles or replaces a word, or indents a line otherwise.
PlantedFault planted(std::string text, std::mt19937_64& random) {
    const auto words = text_words_of(text);
    const TextWord& one = words[random() % words.size()];
    const TextWord& other = words[random() % words.size()];
    const auto line = static_cast<std::size_t>(
        std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(one.start), '\n') + 1);
    const std::string own = text.substr(one.start, one.size);
    switch (random() % 4) {
    case 0: text.erase(one.start, one.size); break;
    case 1: text.insert(one.start, own + " "); break;
    case 2: text.replace(one.start, one.size, text.substr(other.start, other.size)); break;
    default: text.insert(text.rfind('\n', one.start) + 1, 1 + random() % 3, ' ');
    }
    return {std::move(text), line};
}

/// Returns the lines of the errors among messages.
std::vector<std::size_t> error_lines(const std::string& messages) {
    std::vector<std::size_t> lines;
    for (std::size_t at = 0; (at = messages.find(": error: ", at)) != std::string::npos; ++at) {
        const auto start = messages.rfind("text.occ:", at) + 9;
        lines.push_back(std::stoul(messages.substr(start)));
    }
    return lines;
}

} // namespace

TEST_CASE("a single fault has few messages, the first of them near it") {
    std::size_t refused = 0, near = 0, few = 0;
    for (const auto& file : test::occam_programs())
        for (const auto seed : test::seeds(100)) {
            INFO(test::replay(seed), " ", file.string());
            std::mt19937_64 random(seed);
            const PlantedFault fault = planted(test::whole_file(file), random);
            const auto lines = error_lines(test::read_text(fault.text).messages);
            if (lines.empty()) // it may still be a fault of names or types
                continue;
            ++refused;
            near += lines.front() + 2 >= fault.line && lines.front() <= fault.line + 2 ? 1 : 0;
            few += lines.size() <= 3 ? 1 : 0;
        }
    if (!test::all_seeds())
        return;
    MESSAGE(refused << " refused, " << near << " near, " << few << " few");
    CHECK(refused > 300);
    CHECK(near * 100 >= refused * 95);
    CHECK(few * 100 >= refused * 95);
}
