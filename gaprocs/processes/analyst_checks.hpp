#pragma once

#include "gaprocs/problem_registry.hpp"
#include "netlist/kinds/catalogue.hpp"
#include "netlist/network/network.hpp"

#include <cstddef>
#include <vector>

namespace placedpar {

/// What ga.analyst refuses in a netlist before it runs: reports of no island, islands that do not exchange with each
/// other in step, so that their reports would not be of one generation, a problem without a record to analyse, samples
/// from another host than the islands', a choice of an island that there is not. Warns where it would never answer.
/// REQUIRES: ports that must be connected are: the reader refuses a netlist where they are not, before it asks here.
std::vector<Complaint> check_analyst(const Network&, std::size_t process, const ProblemRegistry&);

} // namespace placedpar
