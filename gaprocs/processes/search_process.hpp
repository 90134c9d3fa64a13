#pragma once

#include "gaprocs/problem_registry.hpp"
#include "gaprocs/search_observer.hpp"
#include "netlist/kinds/process_kind.hpp"

namespace placedpar {

/// Returns the kind with the body and the check of a process that holds a population added to it. The traditional
/// algorithm, the master of algorithm A, the island of algorithm B and the island that is itself a master have the same
/// body; which of them it is follows from the ports that are connected. If the observer is not null, it sees every
/// generation. REQUIRES: `problems` and the observer outlive every run.
ProcessKind searching(ProcessKind described, const ProblemRegistry& problems, SearchObserver* observer);

} // namespace placedpar
