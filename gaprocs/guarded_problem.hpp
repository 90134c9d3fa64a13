#pragma once

#include "gaprocs/problem_family.hpp"

namespace placedpar {

/// The same problems, of a program that is built on PlacedPar: what they throw when they are made, evaluated or read
/// becomes a UserError that names the problem.
ProblemFamily guarded(const ProblemFamily&);

} // namespace placedpar
