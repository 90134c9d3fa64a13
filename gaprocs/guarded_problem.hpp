#pragma once

#include "gaprocs/problem_family.hpp"

namespace placedpar {

/// Returns the family, that is, a problem with settable numbers, protected against exceptions of user-defined code. If
/// any function of the problem, its constructor, or the function that makes its measurements throws anything, the
/// returned family throws a UserError with the problem's name.
ProblemFamily guarded(const ProblemFamily&);

} // namespace placedpar
