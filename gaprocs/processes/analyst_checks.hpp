#pragma once

#include "gaprocs/problem_registry.hpp"
#include "netlist/kinds/catalogue.hpp"
#include "netlist/network/network.hpp"

#include <cstddef>
#include <vector>

namespace placedpar {

/// Checks a ga.analyst of a netlist before the run, and returns the errors. An analyst receives the best individuals of
/// islands (searches with windows of different lengths), and chooses one of them as the answer. Each port of the
/// analyst for reports must be connected to an island. The islands must exchange in step with each other, so that their
/// best individuals belong to the same generation. The islands' problem must have a record, and the islands must
/// receive their samples from the same host process as the analyst. If the choice is "fixed", the fixed island must
/// exist. Warns if the analyst would never answer. REQUIRES: all ports that must be connected are connected, which the
/// reader of netlists has checked.
std::vector<Complaint> check_analyst(const Network&, std::size_t process, const ProblemRegistry&);

} // namespace placedpar
