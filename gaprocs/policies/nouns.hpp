#pragma once

#include "gaprocs/policies/policy.hpp"

#include <functional>
#include <string>
#include <vector>

namespace placedpar {

/// A choice that a netlist makes without naming a policy: by a number, a file, the problem or the connections.
struct Form {
    std::string noun; ///< name of the aspect that the form belongs to: "farm"
    std::string name; ///< name of the form: "star"
    std::string about;
    std::string written; ///< text in a netlist that selects the form
    std::string source;  ///< as PolicyDescription::source
    std::string example; ///< arguments of `placedpar` for a run that shows the form; paths are relative to the folder
                         ///< that contains examples/
};

/// One aspect of a genetic algorithm, with its policies. Netlists and the library use the same names. Every netlist
/// parameter that configures the aspect has the aspect's name as its ParameterDescription::noun.
struct Noun {
    std::string name; ///< "selection"
    std::string about;
    /// Other words for the aspect, such as "migration". Several aspects may share a word.
    std::vector<std::string> also_called = {};
    std::vector<PolicyDescription> policies = {};
    /// Takes the text of a policy, and returns the text with all numbers of the policy. Throws the UserErrors of
    /// read_policy(). REQUIRES: the aspect has policies.
    std::function<std::string(const std::string&)> printed = {};
    std::vector<Form> forms = {};
};

/// Returns all aspects: first the aspects of one population, then the aspects of islands, of a pair of searches, and of
/// a farm.
std::vector<Noun> policy_nouns();

} // namespace placedpar
