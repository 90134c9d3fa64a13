#include "explore/compare/differences.hpp"

#include "netlist/kinds/fault_kinds.hpp"
#include "netlist/print/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <set>
#include <tuple>

namespace placedpar {

namespace {

template <class Things>
auto by_name_of(const Things& things) {
    std::map<std::string, const typename Things::value_type*> by_name;
    for (const auto& each : things)
        by_name[each.name] = &each;
    return by_name;
}

class SettingDifferences {
public:
    std::vector<SettingDifference> of(const Network& a, const Network& b) && {
        const auto nodes = by_name_of(b.nodes);
        for (const Node& node : a.nodes)
            if (auto other = nodes.find(node.name); other != nodes.end() && other->second->type == node.type)
                compare(node.name, node.attributes, other->second->attributes);
        compare_wires(a, b);
        const auto processes = by_name_of(b.processes);
        for (const ProcessInstance& process : a.processes)
            if (auto other = processes.find(process.name);
                other != processes.end() && other->second->kind == process.kind)
                compare(process.name, process.parameters, other->second->parameters);
        std::vector<SettingDifference> all;
        for (auto& each : found_)
            all.push_back(std::move(each.second));
        return all;
    }

private:
    template <class Values>
    void compare(const std::string& element, const Values& a, const Values& b) {
        for (const auto& [name, value] : a)
            if (auto other = b.find(name); other != b.end() && other->second != value)
                add(element, name, value, other->second);
    }

    /// Compares wires that have a name. The speed of an unnamed wire depends only on its processors.
    void compare_wires(const Network& a, const Network& b) {
        const auto wires = by_name_of(b.connections);
        for (const LinkConnection& wire : a.connections) {
            const auto other = wires.find(wire.name);
            if (wire.name.empty() || other == wires.end())
                continue;
            if (wire.bits_per_second != other->second->bits_per_second &&
                (has_own_speed(a, wire) || has_own_speed(b, *other->second)))
                add(wire.name, "linkspeed", wire.bits_per_second, other->second->bits_per_second);
            if (wire.metres != other->second->metres)
                add(wire.name, "length", wire.metres, other->second->metres);
        }
    }

    static bool has_own_speed(const Network& network, const LinkConnection& wire) {
        return std::ranges::any_of(std::array{wire.a, wire.b}, [&](const LinkEnd& end) {
            const auto& attributes = network.nodes[end.node].attributes;
            const auto speed = attributes.find("linkspeed");
            return speed != attributes.end() && speed->second != Value(wire.bits_per_second);
        });
    }

    void add(const std::string& element, const std::string& name, const Value& a, const Value& b) {
        SettingDifference& found = found_[{name, print_constant(a), print_constant(b)}];
        found.name = name;
        found.a = print_constant(a);
        found.b = print_constant(b);
        found.elements.push_back(element);
        found.set[fmt::format("{}.{}", element, name)] = found.b;
    }

    std::map<std::tuple<std::string, std::string, std::string>, SettingDifference> found_;
};

using Facts = std::set<std::string>;

std::string wire_fact(const Network& network, const LinkConnection& wire) {
    std::string a = link_name(network.nodes, wire.a), b = link_name(network.nodes, wire.b);
    if (b < a)
        std::swap(a, b);
    std::string through;
    for (const SwitchCrossing& crossing : wire.crossings)
        through += " through " + network.nodes[crossing.node].name;
    const bool states_length = wire.name.empty() && wire.metres != 0;
    return fmt::format("{} to {}{}{}", a, b, through, states_length ? fmt::format(", {} m", wire.metres) : "");
}

Facts hardware_of(const Network& network) {
    Facts facts;
    for (const Node& node : network.nodes)
        facts.insert(node.type + " " + node.name);
    for (const LinkConnection& wire : network.connections)
        if (!wire.over_bus)
            facts.insert(wire_fact(network, wire));
    for (const BusAttachment& each : network.attachments)
        facts.insert(fmt::format("{} in slot {} of {}, level {}{}", network.nodes[each.node].name, each.slot,
                                 network.nodes[each.bus].name, each.level,
                                 each.on_request ? ", released on request" : ""));
    return facts;
}

std::string end_fact(const Network& network, const ChannelEnd& end) {
    return end.at_edge() ? end.port : network.processes[end.process].name + "." + end.port;
}

std::string channel_fact(const Network& network, const NetworkChannel& channel) {
    return end_fact(network, channel.from) + " to " + end_fact(network, channel.to);
}

Facts software_of(const Network& network) {
    Facts facts;
    for (const ProcessInstance& process : network.processes)
        facts.insert(fmt::format("{} {}{}{}", process.kind, process.name,
                                 process.high_priority ? ", high priority" : "",
                                 process.program_hash == 0 ? "" : fmt::format(" ({:016x})", process.program_hash)));
    for (const NetworkChannel& channel : network.channels)
        facts.insert(channel_fact(network, channel));
    return facts;
}

/// Returns the processor of each process and the links of each channel. Routes over buses are left out, because the
/// placement determines them.
Facts mapping_of(const Network& network) {
    Facts facts;
    for (const ProcessInstance& process : network.processes)
        if (process.node != nowhere)
            facts.insert(process.name + " on " + network.nodes[process.node].name);
    for (const NetworkChannel& channel : network.channels) {
        std::string route;
        for (const RouteHop& hop : channel.placement.route)
            route += " over " + link_name(network.nodes, begin_of(hop, network.connections));
        if (!route.empty())
            facts.insert(channel_fact(network, channel) + route);
    }
    return facts;
}

Facts faults_of(const Network& network) {
    Facts facts;
    for (const Fault& fault : network.faults)
        facts.insert(print_fault(fault, network.nodes));
    return facts;
}

std::vector<std::string> only_in(const Facts& these, const Facts& others) {
    std::vector<std::string> only;
    std::ranges::set_difference(these, others, std::back_inserter(only));
    return only;
}

} // namespace

const char* name_of(StructureDifference::Section section) {
    constexpr std::array names{"hardware", "software", "mapping", "faults"};
    return names.at(static_cast<std::size_t>(section));
}

std::vector<SettingDifference> setting_differences(const Network& a, const Network& b) {
    return SettingDifferences().of(a, b);
}

std::vector<StructureDifference> structure_differences(const Network& a, const Network& b) {
    using enum StructureDifference::Section;
    std::vector<StructureDifference> differences;
    for (const auto& [section, facts_of] :
         {std::pair(hardware, &hardware_of), {software, &software_of}, {mapping, &mapping_of}, {faults, &faults_of}}) {
        const Facts facts_a = facts_of(a), facts_b = facts_of(b);
        if (facts_a != facts_b)
            differences.push_back({section, only_in(facts_a, facts_b), only_in(facts_b, facts_a)});
    }
    return differences;
}

} // namespace placedpar
