#pragma once

#include "netlist/elaborate/draft.hpp"
#include "netlist/elaborate/evaluator.hpp"

namespace placedpar {

/// These functions handle the attributes in the parentheses of a declaration. They throw StatementRefused after
/// reporting an error.

/// Evaluates attributes. Groups are flattened: `order (code = 1)` becomes "order.code". No attribute may be given
/// twice.
std::vector<Setting> evaluate_attributes(Evaluator& evaluator, Reporter& reporter,
                                         const std::vector<Attribute>& attributes);

/// Returns the note "given first at line ...", for an error about a value that is given twice.
SecondPlace first_given(const Location& at);
/// Reports `the parameter "n" of "p" is given twice`. Throws StatementRefused.
[[noreturn]] void refuse_given_twice(Reporter& reporter, const Setting& second, std::string_view what,
                                     const std::string& whose, const Location& first);

/// `scopes` must contain the types that the attribute `type` may name.
void apply_node_attributes(NodeType& type, const std::vector<Setting>& settings, const Scopes& scopes,
                           Reporter& reporter);
/// Returns whether the node can have an attribute of this name. Returns false for `type`.
bool has_node_attribute(const Node& node, const std::string& name);
/// REQUIRES: has_node_attribute(node, setting.name).
void apply_node_attribute(Node& node, const Setting& setting, Reporter& reporter);
void apply_connection_attributes(DraftConnection& connection, const std::vector<Setting>& settings, Reporter& reporter);

/// Returns the attributes of a wire, followed by the attributes of a master's connection to a bus.
const std::vector<AttributeDescription>& connection_attributes();

bool is_process_attribute(const std::string& name);
const std::vector<std::string>& process_attribute_names();
/// REQUIRES: is_process_attribute(setting.name).
void apply_process_attribute(DraftProcess& process, const Setting& setting, Reporter& reporter);

} // namespace placedpar
