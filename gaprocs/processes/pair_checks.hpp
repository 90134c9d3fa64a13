#pragma once

#include "gaprocs/problem_registry.hpp"
#include "netlist/kinds/catalogue.hpp"
#include "netlist/network/network.hpp"

#include <cstddef>
#include <vector>

namespace placedpar {

/// Returns the errors of a ga.coarse or ga.fine in a netlist before it runs; check_search() returns the errors that any
/// search can have. The fields must be those of the problem, and the stated bits of each field must be possible. A fine
/// search must have the same host, problem, fields, coding, window, trials and bias as its coarse search.
std::vector<Complaint> check_pair(const Network&, std::size_t process, const ProblemRegistry&);

} // namespace placedpar
