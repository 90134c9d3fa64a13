#pragma once

#include "netlist/kinds/machine_use.hpp"

#include <boost/json/fwd.hpp>

#include <string>
#include <vector>

namespace placedpar {

/// Print the effects of faults, and the messages that were lost in switches, each under a heading; "" if there are
/// none.
std::string print_faults(const std::vector<FaultUse>&);
std::string print_switches(const std::vector<SwitchUse>&);

/// Return the same in JSON. Times are in picoseconds.
boost::json::object json_of_fault(const FaultUse&);
boost::json::object json_of_switch(const SwitchUse&);

} // namespace placedpar
