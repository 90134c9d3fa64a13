#pragma once

#include "gaprocs/problem_family.hpp"

namespace placedpar {

/// Returns the same family with guards for the problems of a program that is built on PlacedPar. Any exception from
/// making a problem or its record, or from calling the problem, becomes a UserError that names the problem.
ProblemFamily guarded(const ProblemFamily&);

} // namespace placedpar
