#pragma once

#include "gaprocs/problem_registry.hpp"
#include "netlist/kinds/catalogue.hpp"
#include "netlist/network/network.hpp"

#include <cstddef>
#include <vector>

namespace placedpar {

/// Returns the errors of a ga.analyst in a netlist before it runs: a report that does not come from an island, islands
/// that do not exchange in step with each other, a problem without a record, samples from another host than the
/// islands' samples, the choice of an island that does not exist. Islands out of step would report bests of different
/// generations. Warns if the analyst would never give an answer. REQUIRES: all ports that must be connected are
/// connected; the reader of netlists checks this before.
std::vector<Complaint> check_analyst(const Network&, std::size_t process, const ProblemRegistry&);

} // namespace placedpar
