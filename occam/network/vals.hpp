#pragma once

#include "netlist/language/made_netlist.hpp"
#include "occam/language/tree.hpp"
#include "text/reporter.hpp"

#include <optional>

namespace placedpar::occam {

/// Returns a constant of occam as a value for a netlist; nothing for a record, an infinite number or a NaN, and for an
/// array unless it is of BYTE.
std::optional<Value> netlist_value(const Constant&, const Type&);

/// Gives a checked VAL the value that the ValChoice returns, by which options change constants. Changes nothing if the
/// ValChoice is empty, if the VAL is in a built-in library, or if netlists lack its type. Reports a value that does not
/// fit the type.
void choose_val(Program&, Declaration& val, const ValChoice&, Reporter&);

} // namespace placedpar::occam
