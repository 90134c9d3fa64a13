#pragma once

#include "gaprocs/policies/policy.hpp"
#include "netlist/kinds/catalogue.hpp"

#include <boost/json/fwd.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace placedpar {

// What there is to decide about a genetic algorithm (gaprocs/policies/nouns.hpp), the policies that there are for it,
// and the parameters of the catalogue's processes that name them.

/// What stands for all of it where a kind is asked for by name.
inline constexpr std::string_view policies_group = "policies";

/// Every name that it can be asked for by: "policies", what there is to decide, policies, forms.
std::vector<std::string> policy_names();
/// Whether the name stands for some of it: one of policy_names() in letters of either case and with blanks for hyphens,
/// a policy with its numbers, another word for what is decided (Noun::also_called), or a parameter that decides it.
bool is_policy(const Catalogue&, const std::string& name);

/// All of it, a line for each policy.
std::string print_policies();
/// Everything about what the name stands for: what is decided, by which parameters of which processes, the policies
/// with their numbers, how a netlist writes them, and where they are from, and the forms. A name may be that of
/// several. Throws UserError, saying what would be right, for a policy with numbers that it does not take. REQUIRES:
/// is_policy().
std::string print_policy(const Catalogue&, const std::string& name);
/// All that print_policy() says. Throws as that. REQUIRES: is_policy().
boost::json::array policies_json(const Catalogue&, const std::string& name);

/// The numbers of a policy, or of a family of problems: a line for each, under a heading; "" where it has none.
std::string print_numbers(const PolicyDescription&);
boost::json::array numbers_json(const PolicyDescription&);

} // namespace placedpar
