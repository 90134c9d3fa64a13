#pragma once

#include "netlist/kinds/catalogue.hpp"
#include "netlist/network/network.hpp"

#include <cstddef>
#include <vector>

namespace placedpar {

/// The slaves form trees; each master has its results back where its tasks come from, has no other slaves, and sends
/// each slave one task a generation.
std::vector<Complaint> check_pipeline(const Network&, std::size_t process);

} // namespace placedpar
