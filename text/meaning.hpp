#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace placedpar {

/// A name, and what it stands for, in words: a command and its line in a list of commands.
struct NamedMeaning {
    std::string name, about;
};

/// Returns the names that fit the wanted words by meaning, in the order of the list. A name fits if it, together with
/// its description, has all wanted words. Inflected words fit each other ("simulate", "simulation"). Numbers and
/// single letters must be equal and stand next to each other: "figure-4-6" fits "figures-4-6-4-7", and "a description
/// that has (Figure 4.6)", but not "figure-4-9".
std::vector<std::string> names_by_meaning(std::string_view wanted, const std::vector<NamedMeaning>&);

/// Returns `unknown WHAT "wanted"; did you mean "name"?`. The name fits by its meaning, or else by its spelling. Up to
/// three names that fit by meaning are listed; if more or none fit, the text after the semicolon is `otherwise`.
std::string unknown_meaning(std::string_view what, std::string_view wanted, const std::vector<NamedMeaning>& candidates,
                            std::string_view otherwise);

} // namespace placedpar
