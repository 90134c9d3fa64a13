#pragma once

#include "gaprocs/policies/policy.hpp"

#include <functional>
#include <string>
#include <vector>

namespace placedpar {

/// A choice about a genetic algorithm that a netlist makes without naming a policy: by a number, a file, the problem or
/// the connections. The connections of a farm, for example, make it a star or a chain.
struct Form {
    std::string noun; ///< name of the Noun to which the form belongs: "farm"
    std::string name; ///< name of the form: "star"
    std::string about;
    std::string written; ///< text in a netlist that selects the form
    std::string source;  ///< as PolicyDescription::source
    std::string example; ///< arguments of the program `placedpar` for a run that shows the form; paths are relative to
                         ///< the folder that contains examples/
};

/// One aspect of a genetic algorithm, such as selection, with its policies: the ways to do this step. `placedpar kinds
/// policies` lists the policies. Netlists and the library use the same names. Each netlist parameter that configures
/// the aspect has the aspect's name in ParameterDescription::noun.
struct Noun {
    std::string name; ///< "selection"
    std::string about;
    /// Other words for the aspect, such as "migration". Several aspects may share a word.
    std::vector<std::string> also_called = {};
    std::vector<PolicyDescription> policies = {};
    /// Takes the text of a policy, such as "tournament", and returns the text with all numbers, such as
    /// "tournament(size = 2)". Throws the UserErrors of read_policy(). REQUIRES: the aspect has policies.
    std::function<std::string(const std::string&)> printed = {};
    std::vector<Form> forms = {};
};

/// Returns all aspects: first the aspects of one population, then the aspects of islands, of a pair of searches, and of
/// a farm.
std::vector<Noun> policy_nouns();

} // namespace placedpar
