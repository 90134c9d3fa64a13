#pragma once

#include "gaprocs/problem_registry.hpp"
#include "netlist/kinds/catalogue.hpp"
#include "netlist/network/network.hpp"

#include <cstddef>
#include <functional>
#include <vector>

namespace placedpar {

/// What ga.island refuses in a netlist before it runs: connections that no topology has, another topology than the
/// parameter says, neighbours of which one would wait for the other for ever or could not understand it, more emigrants
/// or immigrants than there is room for. Warns, once a netlist, of islands in parts that exchange nothing, of islands
/// none of which is connected where none says topology = "none", and of a run that ends before the first exchange.
/// What `check_search` says of an island stands before what is said of its exchange.
std::vector<Complaint> check_islands(const Network&, const ProblemRegistry&,
                                     const std::function<std::vector<Complaint>(std::size_t process)>& check_search);

} // namespace placedpar
