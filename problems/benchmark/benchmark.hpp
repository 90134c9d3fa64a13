#pragma once

#include "gaprocs/problem_registry.hpp"

namespace placedpar {

/// Adds the usual benchmark problems (functions of real numbers, binary strings, tours), each with its parameters.
void add_benchmark_problems(ProblemRegistry&);

} // namespace placedpar
