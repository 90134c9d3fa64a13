#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace placedpar {

/// A name and its description in words, such as a command and its line in a list of commands.
struct NamedMeaning {
    std::string name, about;
};

/// Returns the names that fit the wanted words by meaning, in the order of the list. A name fits if the name and its
/// description together have all wanted words. Inflected words fit each other ("simulate", "simulation"). Numbers and
/// single letters must be equal and stand next to each other: "figure-4-6" fits "figures-4-6-4-7", and "a description
/// that has (Figure 4.6)", but not "figure-4-9".
std::vector<std::string> names_by_meaning(std::string_view wanted, const std::vector<NamedMeaning>&);

/// Returns `unknown WHAT "wanted"; did you mean "name"?`. Lists the names that fit by meaning, at most three. If none
/// or more than three fit, suggests the name with the nearest spelling instead. If no name is near, the text after the
/// semicolon is `otherwise`.
std::string unknown_meaning(std::string_view what, std::string_view wanted, const std::vector<NamedMeaning>& candidates,
                            std::string_view otherwise);

} // namespace placedpar
