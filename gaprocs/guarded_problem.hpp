#pragma once

#include "gaprocs/problem_family.hpp"

namespace placedpar {

/// Guards the problems of a program that is built on PlacedPar: what they throw while one or its record is made,
/// or it is asked anything, becomes a UserError that names the problem.
ProblemFamily guarded(const ProblemFamily&);

} // namespace placedpar
