#pragma once

#include "netlist/kinds/process_kind.hpp"
#include "occam/language/tree.hpp"
#include "text/reporter.hpp"

#include <optional>
#include <string>
#include <vector>

namespace placedpar::occam {

/// Returns the name in a netlist: `to_right` for `to.right`.
std::string netlist_name(const std::string& name);

/// Returns the protocol of a channel or of an array of channels.
const ProtocolType& protocol_of(const Type&);

/// Returns whether a parameter is a channel of the server's protocol, SP.
bool leads_to_server(const Declaration& parameter);

/// Returns whether a parameter is a channel of a terminal: keyboard, screen or error, of BYTE.
bool leads_to_terminal(const Declaration& parameter);

/// Returns the direction in which the procedure uses the channel parameter. If the procedure does not use it, returns
/// the direction that the parameter states, or the direction of the terminal's channel; `unused` if neither is known.
Direction direction_of(const Declaration& parameter);

/// Returns the text of a protocol's items: "INT::[]BYTE; BYTE".
std::string text_of_items(const std::vector<ProtocolItem>&);

/// Returns the text of a protocol with its items: "INT::[]BYTE", "P IS INT; BYTE". Two ports agree if these texts are
/// equal.
std::string text_of(const ProtocolType&);

/// Returns the kind of processes that execute a checked procedure: its ports and parameters. Returns nothing, after
/// reporting, if a netlist cannot give a value to one of the parameters.
std::optional<ProcessKind> kind_of(const Program&, const Declaration& procedure, Reporter&);

} // namespace placedpar::occam
