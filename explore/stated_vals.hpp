#pragma once

#include <map>
#include <string>

namespace placedpar {

struct Network; // netlist/network/network.hpp

/// Returns the expressions of the constants (`val`) in the files of a netlist, by name. If the option --set sets a
/// constant, returns the option's expression. Leaves out constants in blocks, because --set cannot set them.
std::map<std::string, std::string> stated_vals(const Network&);

} // namespace placedpar
