#pragma once

#include "gaprocs/problem_registry.hpp"
#include "netlist/kinds/process_kind.hpp"

namespace placedpar {

class Catalogue;

/// Adds every kind below. The processes find their search problem by name in `problems`, which must outlive every run.
void add_genetic_algorithm_kinds(Catalogue&, const ProblemRegistry& problems);

// The kinds, each in a file of its own: what it is for, and its ports, parameters, measurements and body.

ProcessKind host_kind(const ProblemRegistry& problems);        ///< ga.host, in host.cpp
ProcessKind traditional_kind(const ProblemRegistry& problems); ///< ga.traditional, in traditional.cpp
ProcessKind master_kind(const ProblemRegistry& problems);      ///< ga.master, in master.cpp
ProcessKind slave_kind(const ProblemRegistry& problems);       ///< ga.slave, in slave.cpp
ProcessKind island_kind(const ProblemRegistry& problems);      ///< ga.island, in island.cpp

} // namespace placedpar
