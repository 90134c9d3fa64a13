#pragma once

#include "gaprocs/problem_registry.hpp"
#include "netlist/kinds/catalogue.hpp"
#include "netlist/network/network.hpp"

#include <cstddef>
#include <vector>

namespace placedpar {

/// Returns the errors of a ga.coarse or ga.fine in a netlist before it runs, beyond the checks of every search. Refused
/// are fields that differ from the problem's, or that cannot be bred with the stated number of bits. A fine search must
/// also have the host, problem, fields, windows, trials and coding of its coarse search.
std::vector<Complaint> check_pair(const Network&, std::size_t process, const ProblemRegistry&);

} // namespace placedpar
