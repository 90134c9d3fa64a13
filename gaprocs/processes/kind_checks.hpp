#pragma once

#include "gaprocs/problem_registry.hpp"
#include "netlist/kinds/catalogue.hpp"
#include "netlist/network/network.hpp"

#include <cstddef>
#include <vector>

namespace placedpar {

// These functions check the processes of genetic algorithms in a netlist before it runs. The ranges of parameters and
// the connections of ports have already been checked. They refuse settings with which a process cannot work, and
// connections on which a process would wait for ever.

/// Checks a ga.host, the process that sends measurements to searches. Checks that the problem exists, and that its
/// record is long enough for the samples that the host or the sensors send. Checks that each estimate comes from a
/// search that gets its samples from this process.
std::vector<Complaint> check_host(const Network&, std::size_t process, const ProblemRegistry&);
/// Checks a ga.slave, which evaluates individuals for a master. Checks a ga.slave, which evaluates individuals for a
/// master. Checks that the problem exists, that only one process sends tasks to the slave, and that the slave is not
/// part of a circle of slaves.
std::vector<Complaint> check_slave(const Network&, std::size_t process, const ProblemRegistry&);
/// Checks a process with a population. Checks that its settings agree with each other, with the problem and with the
/// host. If the process has slaves, checks that the slaves form a tree, and that their number is the stated number.
/// Also checks that each slave has at least one evaluation to do and has the same problem, and that no message is too
/// long.
std::vector<Complaint> check_search(const Network&, std::size_t process, const ProblemRegistry&);

/// Returns the problem that a process names, or null if it does not exist. The checks above report a missing problem.
const RecordedProblem* named_problem(const ProblemRegistry&, const ProcessInstance&);

} // namespace placedpar
