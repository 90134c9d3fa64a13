#pragma once

#include "gaprocs/problem_registry.hpp"
#include "netlist/kinds/catalogue.hpp"
#include "netlist/network/network.hpp"

#include <cstddef>
#include <vector>

namespace placedpar {

// These are the checks that kinds make on a netlist before it runs, in addition to the checks of ranges and single
// ports. They refuse settings with which a process could not work, and connections on which a process would wait for
// ever.

/// Checks that the problem exists and that its record has the samples that are to be sent.
std::vector<Complaint> check_host(const Network&, std::size_t process, const ProblemRegistry&);
/// Checks that the problem exists, and that the slave has one predecessor and is not part of a circle.
std::vector<Complaint> check_slave(const Network&, std::size_t process, const ProblemRegistry&);
/// Checks that the settings of the search agree with each other and with the problem's record. With slaves, checks also
/// that they form a tree of the stated number of slaves, that each has work and the same problem, and that no message
/// is too long.
std::vector<Complaint> check_search(const Network&, std::size_t process, const ProblemRegistry&);

/// Returns the problem that a process names; null if it does not exist, which the checks above report once.
const RecordedProblem* named_problem(const ProblemRegistry&, const ProcessInstance&);

} // namespace placedpar
