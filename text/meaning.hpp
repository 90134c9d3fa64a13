#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace placedpar {

/// A name and its description in words, such as a command and its line in a list of commands.
struct NamedMeaning {
    std::string name, about;
};

/// Returns the names that a user may mean by the wanted words, in the order of the list. A name fits if all wanted
/// words are in the name or in its description. Forms of one word fit each other ("simulate", "simulation"). Numbers
/// and single letters must be equal and stand next to each other. The wanted words "figure-4-6" thus fit the name
/// "figures-4-6-4-7" and a description with "Figure 4.6". They do not fit "figure-4-9".
std::vector<std::string> names_by_meaning(std::string_view wanted, const std::vector<NamedMeaning>&);

/// Returns `unknown WHAT "wanted"; did you mean "name"?`, with the names that names_by_meaning() returns. If it returns
/// none or more than three, the text has the name with the most similar spelling. If no name is similar, the text after
/// the semicolon is `otherwise`.
std::string unknown_meaning(std::string_view what, std::string_view wanted, const std::vector<NamedMeaning>& candidates,
                            std::string_view otherwise);

} // namespace placedpar
