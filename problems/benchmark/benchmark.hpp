#pragma once

#include "gaprocs/problem_registry.hpp"

namespace placedpar {

/// Adds the problems on which optimisers are usually compared, with their parameters: functions of real numbers, binary
/// strings, tours.
void add_benchmark_problems(ProblemRegistry&);

} // namespace placedpar
