#pragma once

#include "gaprocs/problem_family.hpp"
#include "netlist/kinds/process_kind.hpp"

#include <vector>

namespace placedpar {

/// The main() of a program that does with netlists what placedpar does (run, explain, check, show, kinds, sweep,
/// report), and knows kinds and search problems of its own beside PlacedPar's. Messages and help call it by the name of
/// its file. Returns the exit code; a kind or a problem whose name is taken is a user's error.
int run_program(int argc, char** argv, std::vector<ProcessKind> own_kinds,
                std::vector<ProblemFamily> own_problems = {});

} // namespace placedpar
