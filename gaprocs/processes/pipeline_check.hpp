#pragma once

#include "netlist/kinds/catalogue.hpp"
#include "netlist/network/network.hpp"

#include <cstddef>
#include <vector>

namespace placedpar {

/// Checks that the slaves behind a pipeline form trees. Checks for each master that its results return from the
/// pipeline to which its tasks go, that it has no other slaves, and that it sends each slave one task per generation.
std::vector<Complaint> check_pipeline(const Network&, std::size_t process);

} // namespace placedpar
