#pragma once

#include "gaprocs/problem_family.hpp"

namespace placedpar {

/// Guards the problems of a program that is built on PlacedPar: any exception from making a problem or its record, or
/// from calling the problem, becomes a UserError that names the problem.
ProblemFamily guarded(const ProblemFamily&);

} // namespace placedpar
