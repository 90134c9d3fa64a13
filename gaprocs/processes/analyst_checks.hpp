#pragma once

#include "gaprocs/problem_registry.hpp"
#include "netlist/kinds/catalogue.hpp"
#include "netlist/network/network.hpp"

#include <cstddef>
#include <vector>

namespace placedpar {

/// Checks a ga.analyst of a netlist before the run, and returns the errors. Each report must come from an island. The
/// islands must exchange in step with each other, otherwise their best individuals would belong to different
/// generations. The islands' problem must have a record, and the islands must receive their samples from the analyst's
/// host. A fixed choice must name an existing island. Warns if the analyst would never answer. REQUIRES: all ports that
/// must be connected are connected, which the reader of netlists has checked.
std::vector<Complaint> check_analyst(const Network&, std::size_t process, const ProblemRegistry&);

} // namespace placedpar
