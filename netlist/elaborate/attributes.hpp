#pragma once

#include "netlist/elaborate/draft.hpp"
#include "netlist/elaborate/evaluator.hpp"

namespace placedpar {

/// These functions handle the attributes that follow a name in parentheses, as in `T800 (memory = 4M) t;`. They throw
/// StatementRefused after reporting an error.

/// Evaluates attributes. An attribute in a group gets a longer name: `order (code = 1)` becomes "order.code". Refuses
/// an attribute that is given twice.
std::vector<Setting> evaluate_attributes(Evaluator& evaluator, Reporter& reporter,
                                         const std::vector<Attribute>& attributes);

/// Returns the note "given first at line ...", for an error about a value that is given twice.
SecondPlace first_given(const Location& at);
/// Reports an error such as `the parameter "n" of "p" is given twice`, where `what` is "parameter" and `whose` is "p".
/// Throws StatementRefused.
[[noreturn]] void refuse_given_twice(Reporter& reporter, const Setting& second, std::string_view what,
                                     const std::string& whose, const Location& first);

/// Sets attributes of a type of nodes. `scopes` holds the types that the attribute `type` may name.
void apply_node_attributes(NodeType& type, const std::vector<Setting>& settings, const Scopes& scopes,
                           Reporter& reporter);
/// Returns whether the attribute of this name can be set after the declaration of the node. This excludes `type`.
bool has_node_attribute(const Node& node, const std::string& name);
/// Sets an attribute of a node. REQUIRES: has_node_attribute(node, setting.name).
void apply_node_attribute(Node& node, const Setting& setting, Reporter& reporter);
void apply_connection_attributes(DraftConnection& connection, const std::vector<Setting>& settings, Reporter& reporter);

/// Returns descriptions of all attributes of a `connection`: first those for a wire, then those for the connection of a
/// master to a bus.
const std::vector<AttributeDescription>& connection_attributes();

bool is_process_attribute(const std::string& name);
const std::vector<std::string>& process_attribute_names();
/// Sets an attribute of a process. REQUIRES: is_process_attribute(setting.name).
void apply_process_attribute(DraftProcess& process, const Setting& setting, Reporter& reporter);

} // namespace placedpar
