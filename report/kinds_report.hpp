#pragma once

#include "netlist/kinds/catalogue.hpp"

#include <boost/json/fwd.hpp>

#include <optional>
#include <string>

namespace placedpar {

/// Prints the kinds of processes and devices, a line for each, and the names by which devices are declared.
std::string print_kinds(const Catalogue&);
/// Prints everything about the process kind of this name (ports, parameters and measures) or about the device of this
/// name. For the name of a group, such as "csp" in "csp.prefix", or "processes" or "devices", prints a line for each
/// kind in the group. Throws UserError with the nearest name if nothing has this name.
std::string print_kind(const Catalogue&, const std::string& name);

/// Prints a parameter: a line with its name, type, default and range, and a line with its description.
std::string print_parameter(const ParameterDescription&, const std::optional<Value>& by_default);
/// Returns as JSON all that print_parameter() prints.
boost::json::object parameter_json(const ParameterDescription&);

/// Returns {"processes": [...], "devices": [...]}: all that print_kind() prints about the kind with this name, or about
/// each kind in this group; about all kinds if the name is "". A missing default, and a missing end of a range, are
/// null. Throws as print_kind() does.
boost::json::object kinds_json(const Catalogue&, const std::string& name = "");

} // namespace placedpar
