#pragma once

#include "gaprocs/problem_registry.hpp"
#include "netlist/kinds/catalogue.hpp"
#include "netlist/network/network.hpp"

#include <cstddef>
#include <vector>

namespace placedpar {

/// Checks a ga.coarse or ga.fine of a netlist before the run, and returns the errors, except the errors that
/// check_search() returns for any search. The fields must be the fields of the problem, and the stated bits of each
/// field must be possible. A fine search must have the same host, problem, fields, coding, window, trials and bias as
/// its coarse search.
std::vector<Complaint> check_pair(const Network&, std::size_t process, const ProblemRegistry&);

} // namespace placedpar
