#include "text/nearest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <utility>

namespace placedpar {

namespace {

constexpr std::size_t longest_word = 64; // the time to compute the distance grows with the square of a word's length

/// Returns the number of edits that a misspelt word may have: a third of its length, rounded.
std::size_t most_edits(std::string_view word) { return (word.size() + 1) / 3; }

/// Returns the only candidate that begins with the typed text. Returns "" if there are several such candidates, or if
/// fewer than three characters were typed.
std::string completed(std::string_view typed, const std::vector<std::string>& candidates) {
    std::string found;
    for (const auto& candidate : candidates)
        if (typed.size() >= 3 && candidate.size() > typed.size() && lower_case(candidate).starts_with(typed) &&
            candidate != found) {
            if (!found.empty())
                return "";
            found = candidate;
        }
    return found;
}

/// Returns the first candidate, such as "csp.worker", whose part after the last dot is the typed text; "" if there is
/// none.
std::string without_group(std::string_view typed, const std::vector<std::string>& candidates) {
    const std::string end = "." + std::string(typed);
    auto found = std::ranges::find_if(candidates, [&](const std::string& each) { return each.ends_with(end); });
    return found == candidates.end() ? "" : *found;
}

} // namespace

std::string lower_case(std::string_view word) {
    std::string result(word);
    for (auto& c : result)
        c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return result;
}

std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> two_back, last(b.size() + 1), now(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j)
        now[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        two_back = last;
        last = now;
        now[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            auto replaced = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            now[j] = std::min({replaced, last[j] + 1, now[j - 1] + 1});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                now[j] = std::min(now[j], two_back[j - 2] + 1);
        }
    }
    return now[b.size()];
}

std::string nearest_name(std::string_view wanted, const std::vector<std::string>& candidates) {
    if (wanted.size() > longest_word)
        return "";
    if (std::string grouped = without_group(wanted, candidates); !wanted.empty() && !grouped.empty())
        return grouped;
    auto wanted_lower = lower_case(wanted);
    std::string best;
    // A distance is a pair of numbers of edits: the first number ignores upper and lower case, the second number does
    // not.
    std::pair best_distance(most_edits(wanted) + 1, std::size_t{0});
    for (const auto& candidate : candidates) {
        if (candidate.size() > longest_word || candidate == wanted)
            continue;
        std::pair distance(edit_distance(wanted_lower, lower_case(candidate)), edit_distance(wanted, candidate));
        if (distance < best_distance && distance.first < std::max(wanted.size(), candidate.size())) {
            best_distance = distance;
            best = candidate;
        }
    }
    std::string longer = best_distance.first > 1 ? completed(wanted_lower, candidates) : "";
    return longer.empty() ? best : longer;
}

std::string did_you_mean(std::string_view wanted, const std::vector<std::string>& candidates) {
    auto best = nearest_name(wanted, candidates);
    return best.empty() ? "" : "did you mean \"" + best + "\"?";
}

std::string unknown_name(std::string_view what, std::string_view wanted, const std::vector<std::string>& candidates,
                         std::string_view otherwise) {
    auto suggestion = did_you_mean(wanted, candidates);
    return fmt::format("unknown {} \"{}\"; {}", what, wanted, suggestion.empty() ? otherwise : suggestion);
}

} // namespace placedpar
