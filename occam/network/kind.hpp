#pragma once

#include "netlist/kinds/process_kind.hpp"
#include "occam/language/tree.hpp"
#include "text/reporter.hpp"

#include <optional>
#include <string>
#include <vector>

namespace placedpar::occam {

/// Returns the name in a netlist for a name in occam: `to_right` for `to.right`.
std::string netlist_name(const std::string& name);

/// Returns the protocol of a channel or of an array of channels.
const ProtocolType& protocol_of(const Type&);

/// Returns whether a parameter is a channel with the protocol SP, which leads to the host's server.
bool leads_to_server(const Declaration& parameter);

/// Returns whether a parameter is a channel of BYTE named keyboard, screen or error, which leads to a terminal.
bool leads_to_terminal(const Declaration& parameter);

/// Returns the direction in which a procedure uses its channel parameter. If the procedure does not use the parameter,
/// returns the direction that its declaration states, or that of a channel to a terminal. Returns `unused` if none of
/// these is known.
Direction direction_of(const Declaration& parameter);

/// Returns the items of a protocol as text, such as "INT::[]BYTE; BYTE".
std::string text_of_items(const std::vector<ProtocolItem>&);

/// Returns a protocol as text, such as "INT::[]BYTE" or "P IS INT; BYTE". Two ports may be connected if the texts of
/// their protocols are equal.
std::string text_of(const ProtocolType&);

/// Returns the kind of process, with its ports and parameters, that a netlist can make from a procedure. If a netlist
/// cannot give a value to one of the parameters, reports this, and returns nothing. REQUIRES: the procedure was checked
/// without errors.
std::optional<ProcessKind> kind_of(const Program&, const Declaration& procedure, Reporter&);

} // namespace placedpar::occam
