#pragma once

#include "netlist/kinds/process_kind.hpp"

#include <vector>

namespace placedpar {

class Catalogue;

/// Adds all kinds of this folder.
void add_classical_kinds(Catalogue&);

// These functions return the processes of the classical networks, one network per file. Each process ends when it has
// done the work that its parameters state.

std::vector<ProcessKind> philosopher_kinds();    ///< csp.philosopher, csp.fork, csp.butler
std::vector<ProcessKind> sieve_kinds();          ///< csp.numbers, csp.sieve
std::vector<ProcessKind> matrix_kinds();         ///< csp.vector, csp.cell, csp.column
std::vector<ProcessKind> farm_kinds();           ///< csp.balancer, csp.worker
std::vector<ProcessKind> bounded_buffer_kinds(); ///< csp.buffer, csp.customer

} // namespace placedpar
