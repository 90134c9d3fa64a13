#pragma once

#include "gaprocs/policies/policy.hpp"

#include <functional>
#include <string>
#include <vector>

namespace placedpar {

/// What there is to decide about a genetic algorithm, and the policies that there are for it, as netlists and library
/// name them. Which parameters of a netlist decide it, those say: ParameterDescription::noun.
struct Noun {
    std::string name; ///< "selection"
    std::string about;
    std::vector<PolicyDescription> policies = {}; ///< none where a number or a word decides it
    /// The policy that a text names, as it prints itself. Throws UserError as read_policy(). REQUIRES: there are
    /// policies.
    std::function<std::string(const std::string&)> printed = {};
};

/// All of them: first what one population does, then islands, then a farm.
std::vector<Noun> policy_nouns();

} // namespace placedpar
