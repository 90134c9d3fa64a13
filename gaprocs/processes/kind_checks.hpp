#pragma once

#include "gaprocs/problem_registry.hpp"
#include "netlist/kinds/catalogue.hpp"
#include "netlist/network/network.hpp"

#include <cstddef>
#include <vector>

namespace placedpar {

// These checks are made on a netlist before it runs, after the checks of ranges and of ports. They refuse settings with
// which a process could not work, and connections on which a process would wait for ever.

/// Checks that the problem exists, and that its record has enough samples for the host, or the sensors.
std::vector<Complaint> check_host(const Network&, std::size_t process, const ProblemRegistry&);
/// Checks that the problem exists, that the slave has one predecessor, and that it is not part of a circle.
std::vector<Complaint> check_slave(const Network&, std::size_t process, const ProblemRegistry&);
/// Checks that the settings of the search agree with each other and with the problem's record. If the process has
/// slaves, checks that they form a tree with the stated number of slaves. Each slave must have work and the same
/// problem, and each message must be short enough.
std::vector<Complaint> check_search(const Network&, std::size_t process, const ProblemRegistry&);

/// Returns the problem that a process names, or null if it does not exist. The checks above report a missing problem
/// once.
const RecordedProblem* named_problem(const ProblemRegistry&, const ProcessInstance&);

} // namespace placedpar
