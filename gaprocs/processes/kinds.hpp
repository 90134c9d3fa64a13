#pragma once

#include "gaprocs/problem_registry.hpp"

namespace placedpar {

class Catalogue;
class ProcessEnvironment;

/// Adds ga.host, ga.traditional, ga.master, ga.slave and ga.island to the catalogue. The processes find their
/// search problem by name in `problems`, which must outlive every run.
void add_genetic_algorithm_kinds(Catalogue&, const ProblemRegistry& problems);

// The bodies of the kinds.
void run_host(ProcessEnvironment&, const ProblemRegistry&);
void run_slave(ProcessEnvironment&, const ProblemRegistry&);
/// The traditional algorithm, the master of algorithm A, the island of algorithm B and the island that is
/// itself a master are one process; which it is follows from the ports that are connected.
void run_search(ProcessEnvironment&, const ProblemRegistry&);

} // namespace placedpar
