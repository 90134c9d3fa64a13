#include "netlist/elaborate/attribute_value.hpp"
#include "netlist/elaborate/attributes.hpp"
#include "netlist/kinds/description.hpp"
#include "text/counted.hpp"
#include "text/nearest.hpp"

#include <fmt/format.h>

#include <cctype>

namespace placedpar {

namespace {

std::string in_upper_case(std::string text) {
    for (char& c : text)
        c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return text;
}

/// Returns the node type of that name; null if there is none. The name of a predefined type may be in lower case.
const NodeType* find_type(const Scopes& scopes, const std::string& name) {
    for (const auto& each : {name, in_upper_case(name)})
        if (const auto* symbol = scopes.find(each))
            if (const auto* type = std::get_if<NodeType>(&symbol->meaning))
                return type;
    return nullptr;
}

/// Returns the type, changed by the attributes that the netlist gave before it named the type.
NodeType with_attributes_of(NodeType type, const Node& untyped) {
    for (const auto& name : untyped.given)
        type.preset.attributes[name] = untyped.attributes.at(name);
    type.preset.given.insert(untyped.given.begin(), untyped.given.end());
    for (const auto& [name, value] : untyped.other)
        type.preset.other[name] = value;
    if (untyped.rank)
        type.preset.rank = untyped.rank;
    return type;
}

/// Applies `processor (type = "T800")`: replaces the type by another model of the same kind.
void apply_type(NodeType& type, const Setting& setting, const Scopes& scopes, Reporter& reporter) {
    AttributeValue value(setting, reporter);
    auto name = value.text();
    const auto* known = find_type(scopes, name);
    if (known == nullptr || known->preset.kind != type.preset.kind || known->needs_type) {
        auto guess = did_you_mean(name, scopes.predefined_node_types());
        value.illegal(fmt::format("\"{}\"", name),
                      guess.empty() ? "expected a type of processor, such as \"T800\"" : guess);
    }
    type = with_attributes_of(*known, type.preset);
}

/// Refuses an attribute `type` that differs from the type in the declaration's first word.
void check_type(const NodeType& type, const AttributeValue& value) {
    if (auto name = value.text(); in_upper_case(name) != in_upper_case(type.preset.type))
        value.illegal(fmt::format("\"{}\"", name), fmt::format("the type is already {}", type.preset.type));
}

constexpr const char* rank_attribute = "rank";

AttributeDescription rank_description() {
    return {.value = description::integer(rank_attribute, {.least = 0, .most = 999'999}, "thread or MPI rank")};
}

bool can_have_rank(const DeviceKind& kind) { return kind.executes != Execution::none; }

std::vector<std::string> attribute_names(const DeviceKind& kind) {
    std::vector<std::string> names{"type"};
    if (can_have_rank(kind))
        names.push_back(rank_attribute);
    for (const auto& attribute : kind.attributes)
        names.push_back(attribute.value.name);
    names.insert(names.end(), kind.kept.begin(), kind.kept.end());
    return names;
}

void apply_attribute(NodeType& type, const Setting& setting, Reporter& reporter) {
    AttributeValue value(setting, reporter);
    auto& preset = type.preset;
    if (!preset.kind->has_attributes())
        value.refuse_name(with_article(preset.type), {});
    if (has_node_attribute(preset, setting.name))
        apply_node_attribute(preset, setting, reporter);
    else if (setting.name == "type")
        check_type(type, value);
    else
        value.refuse_name("a node", attribute_names(*preset.kind));
}

} // namespace

bool has_node_attribute(const Node& node, const std::string& name) {
    return node.kind->attribute(name) != nullptr || names_attribute(node.kind->kept, name) ||
           (name == rank_attribute && can_have_rank(*node.kind));
}

void apply_node_attribute(Node& node, const Setting& setting, Reporter& reporter) {
    AttributeValue value(setting, reporter);
    if (const auto* attribute = node.kind->attribute(setting.name)) {
        node.attributes[setting.name] = value.as(*attribute);
        node.given.insert(setting.name);
    } else if (setting.name == rank_attribute)
        node.rank = static_cast<std::size_t>(std::get<std::int64_t>(value.as(rank_description())));
    else
        node.other[setting.name] = value.any();
}

void apply_node_attributes(NodeType& type, const std::vector<Setting>& settings, const Scopes& scopes,
                           Reporter& reporter) {
    bool untyped = type.needs_type;
    for (const auto& setting : settings)
        if (setting.name == "type" && untyped)
            apply_type(type, setting, scopes, reporter);
    for (const auto& setting : settings)
        if (setting.name != "type" || !untyped)
            apply_attribute(type, setting, reporter);
}

} // namespace placedpar
