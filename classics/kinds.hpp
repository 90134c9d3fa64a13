#pragma once

#include "netlist/kinds/process_kind.hpp"

#include <vector>

namespace placedpar {

class Catalogue;

/// Adds every kind below.
void add_classical_kinds(Catalogue&);

// The processes of the classical networks, a network a file. Each ends once it has done what its parameters say.

std::vector<ProcessKind> philosopher_kinds();    ///< csp.philosopher, csp.fork, csp.butler
std::vector<ProcessKind> sieve_kinds();          ///< csp.numbers, csp.sieve
std::vector<ProcessKind> matrix_kinds();         ///< csp.vector, csp.cell, csp.column
std::vector<ProcessKind> farm_kinds();           ///< csp.balancer, csp.worker
std::vector<ProcessKind> bounded_buffer_kinds(); ///< csp.buffer, csp.customer

} // namespace placedpar
