#pragma once

#include "gaprocs/problem_registry.hpp"
#include "netlist/kinds/catalogue.hpp"

#include <cstddef>
#include <vector>

namespace placedpar {

// What the kinds refuse of a netlist beyond ranges and single ports, before anything runs: what the bodies of the
// processes could not work with, or would wait for in vain.

/// The problem is known, and its record is as long as what is to be sent.
std::vector<Complaint> check_host(const Network&, std::size_t process, const ProblemRegistry&);
/// The problem is known.
std::vector<Complaint> check_slave(const Network&, std::size_t process, const ProblemRegistry&);
/// The settings of the search fit together and to the problem's record. With slaves: there are as many in the chain as
/// stated, there is work for each, they search the same problem, and their messages are not too long.
std::vector<Complaint> check_search(const Network&, std::size_t process, const ProblemRegistry&);

} // namespace placedpar
