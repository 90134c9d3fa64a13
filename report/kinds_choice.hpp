#pragma once

#include "netlist/kinds/catalogue.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace placedpar {

// These functions interpret the names that a user gives to `placedpar kinds`: kinds of processes and devices, such as
// "csp.prefix", and groups of kinds, such as "csp".

inline constexpr std::string_view processes_group = "processes", devices_group = "devices";

/// Returns the kinds of processes in a group, in order: their names begin with the group's name and a point. For
/// "processes", returns all kinds.
std::vector<const ProcessKind*> group_of(const Catalogue&, std::string_view group);

/// Returns the names of all kinds and groups, in order.
std::vector<std::string> known_names(const Catalogue&);

/// Returns the known name that equals this name apart from upper and lower case. (DOS and INMOS's toolset do not
/// distinguish upper and lower case.) Returns the name itself if no known name is like it.
std::string known_name(const Catalogue&, const std::string& name);

/// Throws UserError for an unknown name; the text suggests a kind, device or group with a similar name, or a similar
/// name among `others`.
[[noreturn]] void refuse_kind(const Catalogue&, const std::string& name, const std::vector<std::string>& others = {});

/// Returns the type as a netlist writes it: "int", "double" or "string".
const char* word(ParameterType);

} // namespace placedpar
