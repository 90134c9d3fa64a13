#include "netlist/kinds/fault_kinds.hpp"
#include "report/kinds_choice.hpp"
#include "report/kinds_report.hpp"

#include <boost/json.hpp>

#include <map>
#include <memory>
#include <optional>

namespace placedpar {

namespace {

namespace json = boost::json;

template <class T>
json::value value_or_null(const std::optional<T>& value) {
    return value ? json::value(*value) : json::value();
}

json::value value_json(const Value& value) {
    return std::visit([](const auto& each) { return json::value(each); }, value);
}

json::array names_json(const std::vector<std::string>& names) { return json::array(names.begin(), names.end()); }

/// Returns an array of `entry(thing)` for each thing.
template <class Things, class Entry>
json::array list(const Things& things, Entry entry) {
    json::array array;
    for (const auto& thing : things)
        array.push_back(entry(thing));
    return array;
}

json::object port_json(const PortDescription& port) {
    return {{"name", port.name},
            {"direction", word(port.direction)},
            {"protocol", port.protocol},
            {"may_stay_unconnected", port.optional},
            {"about", port.about}};
}

json::object measure_json(const MeasurementDescription& measure) {
    return {{"name", measure.name}, {"unit", measure.unit}, {"about", measure.about}};
}

json::object process_json(const ProcessKind& kind) {
    return {{"name", kind.name},
            {"about", kind.about},
            {"ports", list(kind.ports, port_json)},
            {"connected_together", list(kind.together, names_json)},
            {"parameters", list(kind.parameters, parameter_json)},
            {"measures", list(kind.measurements, measure_json)}};
}

/// Describes a model. "defaults" has only the attributes whose defaults differ from those of the device kind.
json::object model_json(const DeviceModel& model) {
    json::object defaults;
    for (const auto& [name, value] : model.attributes)
        defaults[name] = value_json(value);
    return {{"name", model.name},
            {"type", model.type.empty() ? model.name : model.type},
            {"links", model.links},
            {"overlapped_acknowledge", model.overlapped_acknowledge},
            {"needs_type", model.needs_type},
            {"defaults", std::move(defaults)}};
}

const char* word(LinkRole links) {
    return links == LinkRole::ends ? "end wires" : links == LinkRole::crosses ? "cross wires" : "end the network";
}

json::object fault_json(const FaultKind& kind) {
    return {{"name", kind.name},
            {"about", kind.about},
            {"attributes", list(kind.attributes, [](const auto& each) { return parameter_json(each.value); })}};
}

/// Describes a device kind and its model `name`, or all its models if `name` is empty.
json::object device_json(const DeviceKind& kind, const std::string& name) {
    json::array models;
    for (const DeviceModel& model : kind.models)
        if (name.empty() || model.name == name)
            models.push_back(model_json(model));
    return {
        {"name", kind.name},
        {"about", kind.about},
        {"refusal", kind.refusal},
        {"links", word(kind.links)},
        {"runs_processes", kind.executes != Execution::none},
        {"logic", kind.logic},
        {"models", std::move(models)},
        {"attributes", list(kind.attributes, [](const auto& each) { return parameter_json(each.value); })},
        {"without_effect", names_json(kind.kept)},
        {"faults", list(kind.faults, fault_json)},
        {"faults_of_links", list(kind.links == LinkRole::ends ? link_faults() : std::vector<FaultKind>{}, fault_json)}};
}

json::array devices_json(const Catalogue& catalogue, const std::string& name) {
    if (name.empty() || name == devices_group)
        return list(catalogue.devices(), [](const auto& each) { return device_json(*each.second, ""); });
    auto type = catalogue.node_types().find(name);
    return type == catalogue.node_types().end() ? json::array{}
                                                : json::array{device_json(*type->second.preset.kind, name)};
}

json::array processes_json(const Catalogue& catalogue, const std::string& name) {
    if (const ProcessKind* kind = catalogue.find(name))
        return {process_json(*kind)};
    return list(group_of(catalogue, name.empty() ? std::string(processes_group) : name),
                [](const ProcessKind* kind) { return process_json(*kind); });
}

} // namespace

boost::json::object parameter_json(const ParameterDescription& parameter) {
    return {{"name", parameter.name},
            {"type", word(parameter.type)},
            {"unit", parameter.unit},
            {"default", parameter.default_value ? value_json(*parameter.default_value) : json::value()},
            {"least", value_or_null(parameter.least)},
            {"most", value_or_null(parameter.most)},
            {"choices", names_json(parameter.choices)},
            {"about", parameter.about},
            {"decides", parameter.noun}};
}

json::object kinds_json(const Catalogue& catalogue, const std::string& name) {
    json::object document{{"processes", processes_json(catalogue, name)}, {"devices", devices_json(catalogue, name)}};
    if (document["processes"].as_array().empty() && document["devices"].as_array().empty())
        refuse_kind(catalogue, name);
    return document;
}

} // namespace placedpar
