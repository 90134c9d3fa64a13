#pragma once

#include "gaprocs/problem_registry.hpp"

#include <boost/json/fwd.hpp>

#include <string>
#include <string_view>

namespace placedpar {

/// The name that stands for all problems in place of a kind's name.
inline constexpr std::string_view problems_group = "problems";

/// Prints the search problems, a line for each. A family of problems is printed with the numbers in its names, as in
/// `sphere(3)`, and their defaults.
std::string print_problems(const ProblemRegistry&);
/// Prints everything about the problem of this name: the numbers in the name, the objective, and the parameters that
/// are searched. Throws UserError as ProblemRegistry::find() does.
std::string print_problem(const ProblemRegistry&, const std::string& name);

/// Returns as JSON all that print_problem() prints; an unknown optimum is null. Throws as print_problem() does.
boost::json::object problem_json(const ProblemRegistry&, const std::string& name);
/// Returns problem_json() of each problem.
boost::json::array problems_json(const ProblemRegistry&);

} // namespace placedpar
