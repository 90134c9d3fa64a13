#pragma once

#include "gaprocs/problem_registry.hpp"

#include <boost/json/fwd.hpp>

#include <string>
#include <string_view>

namespace placedpar {

/// What stands for all problems where a kind is asked for by name.
inline constexpr std::string_view problems_group = "problems";

/// The search problems, a line for each: those that are told apart by numbers with these, and their defaults.
std::string print_problems(const ProblemRegistry&);
/// Everything about the problem of this name: its numbers, what is searched for, over what. Throws UserError as
/// ProblemRegistry::find().
std::string print_problem(const ProblemRegistry&, const std::string& name);

/// All that print_problem says; an optimum that is not known is null. Throws as print_problem().
boost::json::object problem_json(const ProblemRegistry&, const std::string& name);
/// That of each.
boost::json::array problems_json(const ProblemRegistry&);

} // namespace placedpar
