#pragma once

#include "netlist/kinds/catalogue.hpp"

#include <boost/json/fwd.hpp>

#include <optional>
#include <string>

namespace placedpar {

/// The kinds of processes and of devices, a line for each, and the names that devices are declared by.
std::string print_kinds(const Catalogue&);
/// Everything about the kind of process of this name (its ports, parameters and measures), or about what nodes can be
/// declared with by this name. The name of a group, such as csp of csp.prefix, or "processes" or "devices": its kinds,
/// a line for each. Throws UserError when there is none of that name, with the nearest one.
std::string print_kind(const Catalogue&, const std::string& name);

/// Its name, type, default and range in a line, what it is about in the next.
std::string print_parameter(const ParameterDescription&, const std::optional<Value>& by_default);
/// All of that.
boost::json::object parameter_json(const ParameterDescription&);

/// {"processes": [...], "devices": [...]}: all that print_kind says of the kinds that the name stands for; of all kinds
/// where it is "". A range's ends and a default that are not there are null. Throws UserError as print_kind does.
boost::json::object kinds_json(const Catalogue&, const std::string& name = "");

} // namespace placedpar
