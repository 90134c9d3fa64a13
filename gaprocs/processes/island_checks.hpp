#pragma once

#include "gaprocs/problem_registry.hpp"
#include "netlist/kinds/catalogue.hpp"
#include "netlist/network/network.hpp"

#include <cstddef>
#include <functional>
#include <vector>

namespace placedpar {

/// Checks the islands of a netlist (searches that exchange individuals) before the run, and returns the errors.
/// Connections must join two different islands and agree with the parameter `topology`. Islands that exchange must have
/// the same problem and coding, and the same schedule. The populations must be large enough for the emigrants and
/// immigrants. Warns if islands do not exchange with each other although some island has another topology than "none".
/// Warns if the run ends before the first exchange. For each island, the errors that `check_search` returns come first.
std::vector<Complaint> check_islands(const Network&, const ProblemRegistry&,
                                     const std::function<std::vector<Complaint>(std::size_t process)>& check_search);

} // namespace placedpar
