#pragma once

#include "gaprocs/problem_registry.hpp"
#include "netlist/kinds/catalogue.hpp"
#include "netlist/network/network.hpp"

#include <cstddef>
#include <vector>

namespace placedpar {

/// Returns what is wrong with a ga.analyst in a netlist that has not run yet: a report that does not come from an
/// island; islands that do not exchange with each other in step, so that their reports would be of different
/// generations; a problem without a record; samples from another host than the islands'; the choice of an island that
/// does not exist. Warns if the analyst would never answer. REQUIRES: all ports that must be connected are connected,
/// which the reader checks first.
std::vector<Complaint> check_analyst(const Network&, std::size_t process, const ProblemRegistry&);

} // namespace placedpar
