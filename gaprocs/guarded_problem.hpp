#pragma once

#include "gaprocs/problem_family.hpp"

namespace placedpar {

/// Guards the problems of a program that is built on PlacedPar: what they throw while one is made, its fitness is
/// evaluated or a string is decoded becomes a UserError that names the problem. Other questions, such as bits(), are
/// not guarded.
ProblemFamily guarded(const ProblemFamily&);

} // namespace placedpar
