#pragma once

#include "netlist/kinds/catalogue.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace placedpar {

// What a name can stand for where kinds are asked for, besides a kind itself.

inline constexpr std::string_view processes_group = "processes", devices_group = "devices";

/// The kinds of processes whose name begins with that of the group and a point, in order; of "processes" all.
std::vector<const ProcessKind*> group_of(const Catalogue&, std::string_view group);

/// Every name that kinds can be asked for by, in order.
std::vector<std::string> known_names(const Catalogue&);

/// The known name that this is but for the case of its letters, as DOS and the toolset have it; itself if it is none.
std::string known_name(const Catalogue&, const std::string& name);

/// Throws UserError: there is nothing of that name, but perhaps a kind, device or group of a similar one, or one of the
/// others.
[[noreturn]] void refuse_kind(const Catalogue&, const std::string& name, const std::vector<std::string>& others = {});

/// As a netlist writes it: "int", "double" or "string".
const char* word(ParameterType);

} // namespace placedpar
