#pragma once

#include "netlist/language/made_netlist.hpp"
#include "occam/language/tree.hpp"
#include "text/reporter.hpp"

#include <optional>

namespace placedpar::occam {

/// Returns the constant as a value for a netlist; nothing if it is an array that is not a text.
std::optional<Value> netlist_value(const Constant&, const Type&);

/// Gives a VAL that has been checked the value of the choice. An empty choice, and a VAL of a library or of a type that
/// netlists lack, change nothing. Reports a value that does not fit the type.
void choose_val(Program&, Declaration& val, const ValChoice&, Reporter&);

} // namespace placedpar::occam
