#include "netlist/elaborate/attribute_value.hpp"
#include "netlist/elaborate/attributes.hpp"
#include "text/nearest.hpp"

#include <fmt/format.h>

namespace placedpar {

namespace {

/// `processor (type = "T800")`: another model of the same kind takes its place.
void apply_type(NodeType& type, const Setting& setting, const Scopes& scopes, Reporter& reporter) {
    AttributeValue value(setting, reporter);
    auto name = value.text();
    const auto* symbol = scopes.find(name);
    const auto* known = symbol == nullptr ? nullptr : std::get_if<NodeType>(&symbol->meaning);
    if (known == nullptr || known->preset.kind != type.preset.kind || known->needs_type) {
        auto guess = did_you_mean(name, scopes.predefined_node_types());
        value.illegal(fmt::format("\"{}\"", name),
                      guess.empty() ? "it names a type of processor, such as \"T800\"" : guess);
    }
    type = *known;
}

/// Elsewhere it may only repeat what the declaration's first word says.
void check_type(const NodeType& type, const AttributeValue& value) {
    if (auto name = value.text(); name != type.preset.type && !type.needs_type)
        value.illegal(fmt::format("\"{}\"", name), fmt::format("the type is {} already", type.preset.type));
}

std::vector<std::string> attribute_names(const DeviceKind& kind) {
    std::vector<std::string> names{"type"};
    for (const auto& attribute : kind.attributes)
        names.push_back(attribute.value.name);
    names.insert(names.end(), kind.kept.begin(), kind.kept.end());
    return names;
}

/// "a C004", "an edge".
std::string with_article(const std::string& type) {
    bool vowel = std::string_view("aeiou").find(type[0]) != std::string_view::npos;
    return (vowel ? "an " : "a ") + type;
}

void apply_attribute(NodeType& type, const Setting& setting, Reporter& reporter) {
    AttributeValue value(setting, reporter);
    auto& preset = type.preset;
    if (!preset.kind->has_attributes())
        value.refuse_name(with_article(preset.type), {});
    if (const auto* attribute = preset.kind->attribute(setting.name))
        preset.attributes[setting.name] = value.as(*attribute);
    else if (setting.name == "type")
        check_type(type, value);
    else if (auto names = attribute_names(*preset.kind); names_attribute(names, setting.name))
        preset.other[setting.name] = value.any();
    else
        value.refuse_name("a node", names);
}

} // namespace

void apply_node_attributes(NodeType& type, const std::vector<Setting>& settings, const Scopes& scopes,
                           Reporter& reporter) {
    for (const auto& setting : settings)
        if (setting.name == "type" && type.needs_type)
            apply_type(type, setting, scopes, reporter);
    for (const auto& setting : settings)
        apply_attribute(type, setting, reporter);
}

} // namespace placedpar
