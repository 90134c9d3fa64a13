#pragma once

#include "gaprocs/problem_registry.hpp"

#include <boost/json/fwd.hpp>

#include <string>
#include <string_view>

namespace placedpar {

/// The argument of `placedpar kinds` that stands for all search problems.
inline constexpr std::string_view problems_group = "problems";

/// Prints the search problems, a line for each. A family is problems that differ only in numbers, such as `sphere(3)`.
/// It is printed with the names and defaults of these numbers.
std::string print_problems(const ProblemRegistry&);
/// Prints everything about the problem of this name: the numbers in the name, the objective, and the parameters that
/// are searched. Throws UserError as ProblemRegistry::find() does.
std::string print_problem(const ProblemRegistry&, const std::string& name);

/// Returns as JSON all that print_problem() prints; an unknown optimum is null. Throws as print_problem() does.
boost::json::object problem_json(const ProblemRegistry&, const std::string& name);
/// Returns problem_json() of each problem.
boost::json::array problems_json(const ProblemRegistry&);

} // namespace placedpar
