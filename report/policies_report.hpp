#pragma once

#include "gaprocs/policies/policy.hpp"
#include "netlist/kinds/catalogue.hpp"

#include <boost/json/fwd.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace placedpar {

// These functions describe the steps of a genetic algorithm, such as selection, and the ways to do each step. A way is
// a policy, which a netlist names, such as "tournament", or a form, which a netlist selects otherwise, such as by its
// connections (gaprocs/policies/nouns.hpp). The functions also describe the parameters of processes that select
// policies.

/// The argument of `placedpar kinds` that stands for all policies.
inline constexpr std::string_view policies_group = "policies";

/// Returns the names that is_policy() accepts in exactly this spelling: "policies", and the names of all steps,
/// policies and forms.
std::vector<std::string> policy_names();
/// Returns whether the name stands for a policy, a form or a step. The name may be one of policy_names(), in upper or
/// lower case and with blanks instead of hyphens; a policy with its numbers; another word for a step
/// (Noun::also_called); or a parameter that selects a policy.
bool is_policy(const Catalogue&, const std::string& name);

/// Prints all policies, a line for each.
std::string print_policies();
/// Prints the description of a step, a policy or a form. A step is printed with its parameters and processes; a policy
/// with its numbers, its spelling in a netlist and its source. If the name has several meanings, prints all of them.
/// Throws UserError for a policy with numbers that it does not take; the message says which numbers are allowed.
/// REQUIRES: is_policy().
std::string print_policy(const Catalogue&, const std::string& name);
/// Returns as JSON all that print_policy() prints. Throws as print_policy() does. REQUIRES: is_policy().
boost::json::array policies_json(const Catalogue&, const std::string& name);

/// Prints the numbers that a policy or a family of problems takes: a line for each, under a heading; "" if there are
/// none.
std::string print_numbers(const PolicyDescription&);
boost::json::array numbers_json(const PolicyDescription&);

} // namespace placedpar
