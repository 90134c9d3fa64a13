#pragma once

#include "gaprocs/policies/policy.hpp"

#include <functional>
#include <string>
#include <vector>

namespace placedpar {

/// A choice that a netlist does not make by a policy's name. Instead, a number, a file, the problem or the connections
/// decide.
struct Form {
    std::string noun; ///< name of the aspect that the form belongs to: "farm"
    std::string name; ///< name of the form: "star"
    std::string about;
    std::string written; ///< text in a netlist that selects the form
    std::string source;  ///< as PolicyDescription::source
    std::string example; ///< arguments of `placedpar` that show the form, with paths below the folder that holds
                         ///< examples/
};

/// One aspect of a genetic algorithm, with its policies. Netlists and the library use the same names. The parameters
/// that decide the aspect have its name as their ParameterDescription::noun.
struct Noun {
    std::string name; ///< "selection"
    std::string about;
    /// Other words for the aspect, such as "migration". Several aspects may share a word.
    std::vector<std::string> also_called = {};
    std::vector<PolicyDescription> policies = {};
    /// Returns the full text of the policy that a text names. Throws UserError as read_policy(). REQUIRES: the aspect
    /// has policies.
    std::function<std::string(const std::string&)> printed = {};
    std::vector<Form> forms = {};
};

/// Returns the aspects of one population, then those of islands, of a pair, and of a farm.
std::vector<Noun> policy_nouns();

} // namespace placedpar
