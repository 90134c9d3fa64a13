#pragma once

#include "netlist/kinds/catalogue.hpp"
#include "netlist/network/network.hpp"

#include <cstddef>
#include <vector>

namespace placedpar {

/// Checks a ga.pipeline, a process that passes the tasks of several masters to the same slaves, and returns the errors.
/// The slaves behind the pipeline must form trees. Each master must receive its results from the pipeline to which it
/// sends its tasks, and must have no other slaves. A master must send each slave one task per generation, so `split` =
/// "demand" is not allowed.
std::vector<Complaint> check_pipeline(const Network&, std::size_t process);

} // namespace placedpar
