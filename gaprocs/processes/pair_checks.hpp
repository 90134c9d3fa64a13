#pragma once

#include "gaprocs/problem_registry.hpp"
#include "netlist/kinds/catalogue.hpp"
#include "netlist/network/network.hpp"

#include <cstddef>
#include <vector>

namespace placedpar {

/// What ga.coarse and ga.fine refuse in a netlist before it runs, beside what every search does: fields that are not
/// the problem's, or cannot be bred with these bits; of a fine search also samples from another host than those of its
/// coarse one, another problem, other fields, windows, trials or coding.
std::vector<Complaint> check_pair(const Network&, std::size_t process, const ProblemRegistry&);

} // namespace placedpar
