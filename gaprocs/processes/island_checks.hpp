#pragma once

#include "gaprocs/problem_registry.hpp"
#include "netlist/kinds/catalogue.hpp"
#include "netlist/network/network.hpp"

#include <cstddef>
#include <functional>
#include <vector>

namespace placedpar {

/// Returns what is wrong with the islands of a netlist that has not run yet: connections that are not between two
/// different islands; connections that differ from the parameter `topology`; neighbours one of which would wait for
/// ever for the other or could not read its strings; more emigrants or immigrants than the populations allow. Warns
/// once for the whole netlist of parts that exchange nothing with each other, of islands without any connection unless
/// an island has topology = "none", and of a run that ends before the first exchange. For each island, the complaints
/// of `check_search` come first.
std::vector<Complaint> check_islands(const Network&, const ProblemRegistry&,
                                     const std::function<std::vector<Complaint>(std::size_t process)>& check_search);

} // namespace placedpar
