#pragma once

#include "netlist/kinds/process_kind.hpp"

#include <vector>

namespace placedpar {

class Catalogue;

/// Adds the processes of all classical CSP networks (philosophers, sieve and others) to the kinds that netlists can
/// use.
void add_classical_kinds(Catalogue&);

// Each of the following functions returns the process kinds of one network. Each network has a file in this folder. A
// process ends when it has done the work that its parameters state.

std::vector<ProcessKind> philosopher_kinds();    ///< csp.philosopher, csp.fork, csp.butler
std::vector<ProcessKind> sieve_kinds();          ///< csp.numbers, csp.sieve
std::vector<ProcessKind> matrix_kinds();         ///< csp.vector, csp.cell, csp.column
std::vector<ProcessKind> farm_kinds();           ///< csp.balancer, csp.worker
std::vector<ProcessKind> bounded_buffer_kinds(); ///< csp.buffer, csp.customer
std::vector<ProcessKind> task_kinds();           ///< csp.task

} // namespace placedpar
