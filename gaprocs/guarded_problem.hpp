#pragma once

#include "gaprocs/problem_family.hpp"

namespace placedpar {

/// Returns the family, protected against exceptions of user-defined problems. If the problem's constructor, one of its
/// functions or the making of its record throws anything, the returned family throws a UserError with the problem's
/// name instead.
ProblemFamily guarded(const ProblemFamily&);

} // namespace placedpar
