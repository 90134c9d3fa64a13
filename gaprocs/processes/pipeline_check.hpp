#pragma once

#include "netlist/kinds/catalogue.hpp"
#include "netlist/network/network.hpp"

#include <cstddef>
#include <vector>

namespace placedpar {

/// Checks that the slaves behind a pipeline form trees, and that each master receives its results from the pipeline to
/// which it sends its tasks, has no other slaves, and sends each slave one task a generation.
std::vector<Complaint> check_pipeline(const Network&, std::size_t process);

} // namespace placedpar
