#include "text/meaning.hpp"

#include "text/nearest.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>

namespace placedpar {

namespace {

constexpr std::size_t most_suggestions = 3;

enum class Sort { letters, digits, other };

Sort sort_of(char c) {
    const auto byte = static_cast<unsigned char>(c);
    return std::isdigit(byte) ? Sort::digits : std::isalpha(byte) ? Sort::letters : Sort::other;
}

/// The words of a text in lower case. Numbers and single letters, which number figures and tables, are kept separately.
struct WordsOfText {
    std::vector<std::string> words, numbers;
};

/// Splits the text where letters, digits and other characters meet: "figure-e2" is "figure", "e", "2".
WordsOfText words_of(std::string_view text) {
    WordsOfText out;
    for (std::size_t at = 0, end = 0; at < text.size(); at = end) {
        const Sort sort = sort_of(text[at]);
        while (end < text.size() && sort_of(text[end]) == sort)
            ++end;
        const std::string_view word = text.substr(at, end - at);
        if (sort != Sort::other)
            (sort == Sort::digits || word.size() == 1 ? out.numbers : out.words).push_back(lower_case(word));
    }
    return out;
}

/// Returns whether the words are equal except for their endings: they share at least four letters, two thirds of the
/// shorter word, and more than half of the longer word.
bool are_inflected(std::string_view a, std::string_view b) {
    const auto common = static_cast<std::size_t>(std::ranges::mismatch(a, b).in1 - a.begin());
    return a == b ||
           (common >= 4 && 3 * common >= 2 * std::min(a.size(), b.size()) && 2 * common > std::max(a.size(), b.size()));
}

bool fits(const WordsOfText& wanted, const NamedMeaning& candidate) {
    const WordsOfText has = words_of(candidate.name + " " + candidate.about);
    const auto has_word = [&](const std::string& word) {
        return std::ranges::any_of(has.words, [&](const std::string& each) { return are_inflected(word, each); });
    };
    return std::ranges::all_of(wanted.words, has_word) &&
           (wanted.numbers.empty() || std::search(has.numbers.begin(), has.numbers.end(), wanted.numbers.begin(),
                                                  wanted.numbers.end()) != has.numbers.end());
}

std::vector<std::string> names_of(const std::vector<NamedMeaning>& meanings) {
    std::vector<std::string> names;
    for (const NamedMeaning& each : meanings)
        names.push_back(each.name);
    return names;
}

} // namespace

std::vector<std::string> names_by_meaning(std::string_view wanted, const std::vector<NamedMeaning>& candidates) {
    const WordsOfText words = words_of(wanted);
    std::vector<std::string> names;
    for (const NamedMeaning& each : candidates)
        if (!words.words.empty() && fits(words, each))
            names.push_back(each.name);
    return names;
}

std::string unknown_meaning(std::string_view what, std::string_view wanted, const std::vector<NamedMeaning>& candidates,
                            std::string_view otherwise) {
    const std::vector<std::string> meant = names_by_meaning(wanted, candidates);
    if (meant.empty() || meant.size() > most_suggestions)
        return unknown_name(what, wanted, names_of(candidates), otherwise);
    return fmt::format("unknown {} \"{}\"; did you mean \"{}\"?", what, wanted, fmt::join(meant, "\", or \""));
}

} // namespace placedpar
