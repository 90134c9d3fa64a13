#pragma once

#include "gaprocs/policies/policy.hpp"
#include "netlist/kinds/catalogue.hpp"

#include <boost/json/fwd.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace placedpar {

// These functions describe the aspects of a genetic algorithm (gaprocs/policies/nouns.hpp), the policies for each
// aspect, and the parameters of processes in the catalogue that select policies.

/// The name that stands for all policies in place of a kind's name.
inline constexpr std::string_view policies_group = "policies";

/// Returns every name that is_policy() accepts exactly: "policies", the aspects, the policies and the forms.
std::vector<std::string> policy_names();
/// Returns whether the name stands for a policy, form or aspect. The name may be one of policy_names(), in upper or
/// lower case and with blanks for hyphens; a policy with its numbers; another word for an aspect (Noun::also_called);
/// or a parameter that selects a policy.
bool is_policy(const Catalogue&, const std::string& name);

/// Prints all policies, a line for each.
std::string print_policies();
/// Prints the description of an aspect, a policy or a form. An aspect is printed with its parameters and processes; a
/// policy with its numbers, its spelling in a netlist and its source. If the name has several meanings, prints all of
/// them. Throws UserError for a policy with numbers that it does not take; the message says which numbers are allowed.
/// REQUIRES: is_policy().
std::string print_policy(const Catalogue&, const std::string& name);
/// Returns all that print_policy() prints. Throws as print_policy() does. REQUIRES: is_policy().
boost::json::array policies_json(const Catalogue&, const std::string& name);

/// Prints the numbers that a policy or a family of problems takes: a line for each, under a heading; "" if there are
/// none.
std::string print_numbers(const PolicyDescription&);
boost::json::array numbers_json(const PolicyDescription&);

} // namespace placedpar
