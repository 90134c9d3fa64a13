#pragma once

#include "gaprocs/problem_family.hpp"

namespace placedpar {

/// Returns the same family, protected against errors in user-defined problems. Any exception from a problem's
/// functions, or while the problem or its record of measurements is made, becomes a UserError with the problem's name.
ProblemFamily guarded(const ProblemFamily&);

} // namespace placedpar
