#pragma once

#include "gaprocs/policies/policy.hpp"

#include <functional>
#include <string>
#include <vector>

namespace placedpar {

/// A choice that is not named by a text, but made by a number, a file, the problem or the connections of a netlist.
struct Form {
    std::string noun; ///< what it is a way to do: "farm"
    std::string name; ///< "star"
    std::string about;
    std::string written; ///< how a netlist says it
    std::string source;  ///< as PolicyDescription::source
    std::string example; ///< what follows `placedpar` to see it, below the folder that holds examples/
};

/// One aspect of a genetic algorithm, with the policies for it as netlists and the library name them. The parameters of
/// a netlist that decide it are those with this ParameterDescription::noun.
struct Noun {
    std::string name; ///< "selection"
    std::string about;
    /// Other words by which it is looked for, together with other nouns perhaps: "migration".
    std::vector<std::string> also_called = {};
    std::vector<PolicyDescription> policies = {};
    /// The policy that a text names, as it prints itself. Throws UserError as read_policy(). REQUIRES: there are
    /// policies.
    std::function<std::string(const std::string&)> printed = {};
    std::vector<Form> forms = {};
};

/// Returns the aspects: first those of one population, then those of islands, a pair and a farm.
std::vector<Noun> policy_nouns();

} // namespace placedpar
