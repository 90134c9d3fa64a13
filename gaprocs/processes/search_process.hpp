#pragma once

#include "gaprocs/checkpoints.hpp"
#include "gaprocs/problem_registry.hpp"
#include "gaprocs/search_observer.hpp"
#include "netlist/kinds/process_kind.hpp"

namespace placedpar {

/// Adds the program and the check of a search to the kind `described`, and returns the kind. All processes with a
/// population have this program: the traditional algorithm, the master with slaves (algorithm A of the thesis), the
/// island (algorithm B), and the coarse and the fine search of a pair. The kind and the connected ports decide what the
/// process does. Reports every generation to the observer, unless it is null. Continues from the checkpoints and stores
/// new checkpoints, unless `checkpoints` is null. REQUIRES: `problems`, the observer and the checkpoints outlive every
/// run.
ProcessKind searching(ProcessKind described, const ProblemRegistry& problems, SearchObserver* observer,
                      Checkpoints* checkpoints = nullptr);

} // namespace placedpar
