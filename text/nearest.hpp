#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace placedpar {

/// Returns the word with its ASCII letters in lower case.
std::string lower_case(std::string_view word);

/// Returns the least number of edits that turn one word into the other. An edit inserts, deletes or replaces a
/// character, or swaps two neighbouring characters.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// Returns the candidate that a misspelt word probably means: the candidate with the fewest edits, if at most a third
/// of the word's letters differ. Returns "" if there is none. Upper and lower case decide only between candidates with
/// equally many edits; then the first candidate wins. If only one candidate begins with the word, it is preferred to
/// candidates that need more than one edit. The word "worker" also matches a candidate such as "csp.worker".
std::string nearest_name(std::string_view wanted, const std::vector<std::string>& candidates);

/// Returns `unknown WHAT "wanted"; did you mean "name"?` with nearest_name(). If nearest_name() is "", the text after
/// the semicolon is `otherwise`.
std::string unknown_name(std::string_view what, std::string_view wanted, const std::vector<std::string>& candidates,
                         std::string_view otherwise);

/// Returns `did you mean "name"?` with nearest_name(); "" if nearest_name() is "".
std::string did_you_mean(std::string_view wanted, const std::vector<std::string>& candidates);

} // namespace placedpar
