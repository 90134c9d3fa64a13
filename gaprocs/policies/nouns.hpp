#pragma once

#include "gaprocs/policies/policy.hpp"

#include <functional>
#include <string>
#include <vector>

namespace placedpar {

/// A way that no text names, since a number, a file, the problem or the connections of a netlist decide it.
struct Form {
    std::string noun; ///< what it is a way to do: "farm"
    std::string name; ///< "star"
    std::string about;
    std::string written; ///< how a netlist says it
    std::string source;  ///< as PolicyDescription::source
    std::string example; ///< what follows `placedpar` to see it, below the folder that holds examples/
};

/// What there is to decide about a genetic algorithm, and the policies that there are for it, as netlists and library
/// name them. Which parameters of a netlist decide it, those say: ParameterDescription::noun.
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

/// What there is to decide: first what one population does, then islands, a pair, a farm.
std::vector<Noun> policy_nouns();

} // namespace placedpar
