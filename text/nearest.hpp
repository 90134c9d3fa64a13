#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace placedpar {

/// Returns the word with its ASCII letters in lower case.
std::string lower_case(std::string_view word);

/// Returns the number of single-character insertions, deletions, replacements and swaps of neighbours between two
/// words.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// Returns what a misspelt word means: the nearest candidate, which may differ in at most a third of the word's
/// letters. Case decides only between equally near candidates, and then the first wins. If no candidate is within one
/// letter, the only one that begins with the word is preferred. A candidate such as "csp.worker" is meant by "worker".
/// Returns "" if no candidate is near enough.
std::string nearest_name(std::string_view wanted, const std::vector<std::string>& candidates);

/// Returns `unknown WHAT "wanted"; did you mean "name"?`; if no candidate is near, the text after the semicolon is
/// `otherwise`.
std::string unknown_name(std::string_view what, std::string_view wanted, const std::vector<std::string>& candidates,
                         std::string_view otherwise);

/// Returns `did you mean "name"?`, or "" if no candidate is near.
std::string did_you_mean(std::string_view wanted, const std::vector<std::string>& candidates);

} // namespace placedpar
