#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace placedpar {

/// Returns the ASCII letters of the word.
std::string lower_case(std::string_view word);

/// The number of single-character insertions, deletions, replacements and swaps of neighbours between two
/// words.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// What a misspelt word means: the nearest candidate, at most a third of the word's letters away; case counts only
/// between equals, of which the first wins. Where none is within a letter, rather the only one that begins with the
/// word. "" where nothing is near enough to be meant.
std::string nearest_name(std::string_view wanted, const std::vector<std::string>& candidates);

/// Returns `unknown WHAT "wanted"; did you mean "name"?`, or, where no candidate is near, with `otherwise` behind the
/// semicolon.
std::string unknown_name(std::string_view what, std::string_view wanted, const std::vector<std::string>& candidates,
                         std::string_view otherwise);

/// `did you mean "name"?`, or "" where no candidate is near.
std::string did_you_mean(std::string_view wanted, const std::vector<std::string>& candidates);

} // namespace placedpar
