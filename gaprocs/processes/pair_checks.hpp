#pragma once

#include "gaprocs/problem_registry.hpp"
#include "netlist/kinds/catalogue.hpp"
#include "netlist/network/network.hpp"

#include <cstddef>
#include <vector>

namespace placedpar {

/// Checks a ga.coarse or ga.fine of a netlist before the run, and returns the errors, except the errors that
/// check_search() finds in any search. A ga.coarse searches the whole range with few bits for each parameter, a ga.fine
/// around the best point of the ga.coarse. The fields must be the fields of the problem (the bits of each parameter),
/// and the stated bits of each field must be possible. A fine search must have the same host, problem, fields, coding,
/// window, trials and bias as its coarse search.
std::vector<Complaint> check_pair(const Network&, std::size_t process, const ProblemRegistry&);

} // namespace placedpar
