#include "netlist/complete/complete.hpp"
#include "netlist/kinds/computer.hpp"
#include "netlist/kinds/device_kind.hpp"
#include "netlist/kinds/own_code.hpp"
#include "netlist/network/names.hpp"
#include "runtime/hardware/router.hpp"
#include "text/counted.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace placedpar {

namespace {

const PortBinding* find_binding(const ProcessInstance& process, std::string_view port) {
    auto found = std::ranges::find_if(process.ports, [&](const PortBinding& binding) {
        return binding.port == port || base_name(binding.port) == port;
    });
    return found == process.ports.end() ? nullptr : &*found;
}

void check_together(Completion& c, const ProcessInstance& process, const std::vector<std::string>& ports) {
    const PortBinding* connected = nullptr;
    const std::string* left_out = nullptr;
    for (const auto& port : ports)
        if (const auto* binding = find_binding(process, port))
            connected = binding;
        else
            left_out = &port;
    if (connected == nullptr || left_out == nullptr)
        return;
    c.reporter.error(c.network.channels[connected->channel].connected,
                     fmt::format("the channel \"{0}.{1}\" is connected, but \"{0}.{2}\" is not", process.name,
                                 connected->port, *left_out),
                     fmt::format("the kind \"{}\" needs both channels or neither: connect {}.{} to ...;", process.kind,
                                 process.name, *left_out));
}

/// Returns the place in the netlist for a complaint, an error that the check of a kind has found. It is the place where
/// the parameter is given, or the port is connected. If there is none, returns the place of the process's declaration.
Location place_of(const Completion& c, const Complaint& complaint) {
    const auto& process = c.network.processes[complaint.process];
    if (auto given = process.given.find(complaint.about); given != process.given.end())
        return given->second;
    if (const auto* binding = find_binding(process, complaint.about))
        return c.network.channels[binding->channel].connected;
    return process.declared;
}

void report(Completion& c, const Complaint& complaint) {
    if (complaint.warning)
        c.reporter.warning(place_of(c, complaint), complaint.message, complaint.hint);
    else
        c.reporter.error(place_of(c, complaint), complaint.message, complaint.hint);
}

/// Calls the check of the process's kind, and returns its complaints. If the check throws, returns the exception as a
/// complaint.
std::vector<Complaint> complaints_of(const Completion& c, std::size_t process) {
    const ProcessKind& kind = *c.kinds[process];
    try {
        return ask_kind(kind, [&] { return kind.check(c.network, process); });
    } catch (const UserError& thrown) {
        return {
            {process, "", fmt::format("the kind \"{}\" cannot check this process: {}", kind.name, thrown.what()), ""}};
    }
}

void check_nodes(Completion& c) {
    for (const Node& node : c.network.nodes)
        if (!node.kind->why_not)
            continue;
        else if (std::string reason = ask_device(node, [&] { return node.kind->why_not(node); }); !reason.empty())
            c.reporter.error(node.declared, reason);
}

/// Warns once if a node has the attribute `tolerance` and a channel leads over several wires. How INMOS's configurer
/// icconf uses this attribute is not published. PlacedPar ignores the attribute, so that icconf may choose other
/// routes.
void check_tolerance(Completion& c) {
    auto led_through = [](const NetworkChannel& channel) { return channel.placement.route.size() > 1; };
    auto channel = std::ranges::find_if(c.network.channels, led_through);
    auto node =
        std::ranges::find_if(c.network.nodes, [](const Node& each) { return each.other.contains("tolerance"); });
    if (channel != c.network.channels.end() && node != c.network.nodes.end())
        c.reporter.warning(
            node->declared,
            fmt::format("the attribute \"tolerance\" has no effect on the route of the channel \"{}\"", channel->name),
            "PlacedPar chooses routes by routecost and linkquota; place states the route of a channel");
}

/// Returns for each node how many of the channels that are sent in packets begin there, end there or pass through it.
std::vector<std::int64_t> channels_in_packets(const Network& network) {
    std::vector<std::int64_t> counts(network.nodes.size(), 0);
    for (const NetworkChannel& channel : network.channels) {
        if (!channel.placement.in_packets)
            continue;
        ++counts[begin_of(channel.placement.route.front(), network.connections).node];
        for (const RouteHop& hop : channel.placement.route)
            ++counts[end_of(hop, network.connections).node];
    }
    return counts;
}

/// Returns the memory that the netlist states for the processor, directly or by the name of a module. Returns 0 if the
/// memory is only the default of a bare chip.
std::int64_t stated_memory_bytes(const Node& node) {
    if (!node.attributes.contains("memory"))
        return 0;
    std::int64_t memory = node.integer("memory");
    return memory > 4 * kilobyte || node.given.contains("memory") ? memory : 0;
}

/// Warns if the buffers for packets alone do not fit into the memory of a node. This is not an error, since the memory
/// needed is only an estimate.
void check_room_for_packets(Completion& c) {
    const std::vector<std::int64_t> channels = channels_in_packets(c.network);
    for (std::size_t i = 0; i < channels.size(); ++i) {
        const Node& node = c.network.nodes[i];
        const std::int64_t room = channels[i] * hardware::Route::room;
        const std::int64_t memory = stated_memory_bytes(node);
        if (memory > 0 && room > memory)
            c.reporter.warning(
                node.declared,
                fmt::format("\"{}\" has {} bytes of memory, but the packets of the channels that end at it or "
                            "pass through it need {} bytes ({})",
                            node.name, memory, room, counted(static_cast<std::size_t>(channels[i]), "channel")),
                "give the processor more memory, or route channels elsewhere by routecost or place p.out on LINK;");
    }
}

/// If the process's node has no floating-point unit, returns the first parameter whose default assumes such a unit;
/// otherwise null.
const ParameterDescription* wants_floating_point_unit(const Completion& c, std::size_t process) {
    const ProcessInstance& instance = c.network.processes[process];
    if (c.kinds[process] == nullptr || c.network.nodes[instance.node].floating_point_unit)
        return nullptr;
    for (const ParameterDescription& parameter : c.kinds[process]->parameters)
        if (parameter.computes_reals && !instance.given.contains(parameter.name))
            return &parameter;
    return nullptr;
}

/// Warns if a process's default numbers of cycles assume a floating-point unit that its node does not have. Warns only
/// of the first such process.
void check_floating_point(Completion& c) {
    for (std::size_t i = 0; i < c.network.processes.size(); ++i)
        if (const ParameterDescription* parameter = wants_floating_point_unit(c, i)) {
            const ProcessInstance& process = c.network.processes[i];
            const Node& node = c.network.nodes[process.node];
            return c.reporter.warning(
                process.declared,
                fmt::format("\"{}\" computes with real numbers, but \"{}\", a {}, has no floating-point unit: {} "
                            "= {} is the workload on a T800",
                            process.name, node.name, node.type, parameter->name,
                            std::get<std::int64_t>(*parameter->default_value)),
                fmt::format("state the workload on this processor: {} ({} = ...);", process.name, parameter->name));
        }
}

} // namespace

void complete_checks(Completion& c) {
    check_nodes(c);
    check_tolerance(c);
    const auto& processes = c.network.processes;
    for (std::size_t i = 0; i < processes.size(); ++i)
        if (c.kinds[i] != nullptr)
            for (const auto& ports : c.kinds[i]->together)
                check_together(c, processes[i], ports);
    if (c.reporter.failed())
        return;
    for (std::size_t i = 0; i < processes.size(); ++i)
        if (c.kinds[i] != nullptr && c.kinds[i]->check)
            for (const Complaint& complaint : complaints_of(c, i))
                report(c, complaint);
    if (c.reporter.failed())
        return;
    check_floating_point(c);
    check_room_for_packets(c);
}

} // namespace placedpar
