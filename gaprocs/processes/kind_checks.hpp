#pragma once

#include "gaprocs/problem_registry.hpp"
#include "netlist/kinds/catalogue.hpp"
#include "netlist/network/network.hpp"

#include <cstddef>
#include <vector>

namespace placedpar {

// What the kinds refuse in a netlist before it runs, beyond ranges and single ports: settings that the processes could
// not work with, and messages for which they would wait for ever.

/// The problem is known, and its record has the samples that are to be sent.
std::vector<Complaint> check_host(const Network&, std::size_t process, const ProblemRegistry&);
/// The problem is known; one process is before it, and not in a circle.
std::vector<Complaint> check_slave(const Network&, std::size_t process, const ProblemRegistry&);
/// The settings of the search agree with each other and with the problem's record. With slaves: they form a tree of as
/// many as stated, there is work for each, they search the same problem, and their messages are not too long.
std::vector<Complaint> check_search(const Network&, std::size_t process, const ProblemRegistry&);

/// The problem that a process names; null where there is none of this name, which the checks above say once.
const RecordedProblem* named_problem(const ProblemRegistry&, const ProcessInstance&);

} // namespace placedpar
