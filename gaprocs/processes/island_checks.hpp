#pragma once

#include "gaprocs/problem_registry.hpp"
#include "netlist/kinds/catalogue.hpp"
#include "netlist/network/network.hpp"

#include <cstddef>
#include <functional>
#include <vector>

namespace placedpar {

/// Returns the errors of the islands in a netlist before it runs: connections that do not join two different islands,
/// connections that differ from the parameter `topology`, neighbours with different problems, codings or schedules,
/// more emigrants or immigrants than the populations allow. Warns once for the whole netlist of parts that exchange
/// nothing with each other, of islands without connections unless an island has topology = "none", and of a run that
/// ends before the first exchange. For each island, the complaints of `check_search` come first.
std::vector<Complaint> check_islands(const Network&, const ProblemRegistry&,
                                     const std::function<std::vector<Complaint>(std::size_t process)>& check_search);

} // namespace placedpar
