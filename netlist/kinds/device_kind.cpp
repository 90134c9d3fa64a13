#include "netlist/kinds/device_kind.hpp"

#include <algorithm>

namespace placedpar {

const AttributeDescription* DeviceKind::attribute(std::string_view wanted) const {
    auto found = std::ranges::find_if(attributes, [&](const auto& known) { return known.value.name == wanted; });
    return found == attributes.end() ? nullptr : &*found;
}

bool executes_in_time(const Network& network, std::size_t node) {
    const Execution executes = network.nodes[node].kind->executes;
    return executes == Execution::in_time || (executes == Execution::in_time_on_a_bus && is_on_bus(network, node));
}

std::size_t count_processors(const Network& network) {
    auto executes = [](const Node& node) { return node.kind->executes == Execution::in_time; };
    return static_cast<std::size_t>(std::ranges::count_if(network.nodes, executes));
}

NodeType node_type(const std::shared_ptr<const DeviceKind>& kind, const DeviceModel& model) {
    NodeType type{.preset = {}, .links = model.links, .needs_type = model.needs_type};
    type.preset.type = model.type.empty() ? model.name : model.type;
    type.preset.kind = kind;
    type.preset.overlapped_acknowledge = model.overlapped_acknowledge;
    type.preset.floating_point_unit = model.floating_point_unit;
    type.preset.attributes = model.attributes;
    for (const auto& attribute : kind->attributes)
        type.preset.attributes.emplace(attribute.value.name, attribute.value.default_value.value());
    return type;
}

const AttributeDescription* FaultKind::attribute(std::string_view name) const {
    auto found =
        std::ranges::find(attributes, name, [](const auto& each) { return std::string_view(each.value.name); });
    return found == attributes.end() ? nullptr : &*found;
}

} // namespace placedpar
