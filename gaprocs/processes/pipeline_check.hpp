#pragma once

#include "netlist/kinds/catalogue.hpp"
#include "netlist/network/network.hpp"

#include <cstddef>
#include <vector>

namespace placedpar {

/// Checks that the slaves behind a pipeline form trees. Each master's results must return from the pipeline to which
/// its tasks go. A master must have no other slaves, and must send each slave one task per generation.
std::vector<Complaint> check_pipeline(const Network&, std::size_t process);

} // namespace placedpar
