#pragma once

#include <map>
#include <string>

namespace placedpar {

struct Network; // netlist/network/network.hpp

/// Returns the expressions of the vals in the files of a netlist, by the names of the vals; for a val that an option
/// sets, returns the option's expression. Leaves out vals in blocks, since no option can set them.
std::map<std::string, std::string> stated_vals(const Network&);

} // namespace placedpar
