#pragma once

#include "gaprocs/problem_registry.hpp"

namespace placedpar {

/// Adds the usual benchmark problems of genetic algorithms (functions of real numbers, binary strings, tours) to the
/// problems that netlists can name.
void add_benchmark_problems(ProblemRegistry&);

} // namespace placedpar
