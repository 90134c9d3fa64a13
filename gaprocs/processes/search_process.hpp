#pragma once

#include "gaprocs/problem_registry.hpp"
#include "gaprocs/search_observer.hpp"
#include "netlist/kinds/process_kind.hpp"

namespace placedpar {

/// Adds the body and the check of a search to a described kind, and returns the kind. All processes with a population
/// have this body: the traditional algorithm, the master of algorithm A, the island of algorithm B, and an island with
/// slaves. The connected ports decide how the process behaves. If the observer is not null, it is given every
/// generation. REQUIRES: `problems` and the observer outlive every run.
ProcessKind searching(ProcessKind described, const ProblemRegistry& problems, SearchObserver* observer);

} // namespace placedpar
