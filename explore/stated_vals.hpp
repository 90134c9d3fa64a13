#pragma once

#include <map>
#include <string>

namespace placedpar {

struct Network; // netlist/network/network.hpp

/// Returns the expressions of the vals in the files of a netlist, by the names of the vals; for a val that an option
/// sets, returns the option's expression. Reads only vals that begin a line and end on it.
std::map<std::string, std::string> stated_vals(const Network&);

} // namespace placedpar
