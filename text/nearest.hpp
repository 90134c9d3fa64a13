#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace placedpar {

/// Returns the word with its ASCII letters in lower case.
std::string lower_case(std::string_view word);

/// Returns the number of edits that turn one word into the other. An edit inserts, deletes or replaces a character, or
/// swaps two neighbours.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// Returns the candidate that a misspelt word probably means: the nearest one, if at most a third of the word's letters
/// differ. Upper and lower case decide only between equally near candidates. Of candidates that are still equal, the
/// first is chosen. If no candidate is within one edit, the only candidate that begins with the word is preferred. The
/// word "worker" also matches a candidate such as "csp.worker". Returns "" if no candidate is near enough.
std::string nearest_name(std::string_view wanted, const std::vector<std::string>& candidates);

/// Returns `unknown WHAT "wanted"; did you mean "name"?`; if no candidate is near, the text after the semicolon is
/// `otherwise`.
std::string unknown_name(std::string_view what, std::string_view wanted, const std::vector<std::string>& candidates,
                         std::string_view otherwise);

/// Returns `did you mean "name"?`, or "" if no candidate is near.
std::string did_you_mean(std::string_view wanted, const std::vector<std::string>& candidates);

} // namespace placedpar
