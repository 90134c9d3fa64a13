#include "netlist/complete/complete.hpp"
#include "netlist/kinds/device_kind.hpp"
#include "netlist/kinds/file_kinds.hpp"
#include "netlist/network/names.hpp"
#include "runtime/transputer/image.hpp"
#include "runtime/transputer/model.hpp"
#include "text/counted.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace placedpar {

namespace {

const ProcessKind* code_kind(const Completion& c, const DraftProcess& process) {
    const ProcessKind* kind = c.catalogue.find(process.kind);
    return kind && kind->is_code ? kind : nullptr;
}

bool is_unplaced_code(const Completion& c, const DraftProcess& process) {
    return process.node == nowhere && code_kind(c, process);
}

bool uses_host(const ProcessKind& kind) {
    return std::ranges::any_of(kind.ports, [](const PortDescription& port) { return port.to_host; });
}

/// Adds a node of this type, with a name that no other node has, and returns its index.
std::size_t add_node(Completion& c, const std::string& type, std::string name, const Location& at) {
    const NodeType& known = c.catalogue.node_types().find(type)->second;
    Node node = known.preset;
    while (find_named(c.network.nodes, name) || find_named(c.draft.processes, name))
        name += "_";
    node.name = std::move(name);
    node.declared = at;
    c.network.nodes.push_back(std::move(node));
    c.draft.links.push_back(known.links);
    return c.network.nodes.size() - 1;
}

/// Adds the transputer that all processes share if none of them is placed.
std::size_t add_shared_transputer(Completion& c, const Location& at) {
    const std::size_t root = add_node(c, "T800", "root", at);
    c.network.nodes[root].attributes.insert_or_assign("memory", std::int64_t{2} << 20);
    c.network.nodes[root].given.insert("memory");
    return root;
}

} // namespace

void place_code(Completion& c) {
    const auto unplaced = [&](const DraftProcess& process) { return is_unplaced_code(c, process); };
    if (c.draft.processes.empty() || !std::ranges::all_of(c.draft.processes, unplaced))
        return;
    const Location at = c.draft.processes.front().declared;
    const std::size_t root = add_shared_transputer(c, at);
    bool has_host = false;
    for (DraftProcess& process : c.draft.processes) {
        process.node = root;
        process.placed = process.declared;
        has_host |= uses_host(*code_kind(c, process));
    }
    if (has_host)
        c.draft.wires.push_back({{root, 0}, {add_node(c, "edge", "host", at), -1}, nowhere, at});
}

namespace {

void check_code_type(Completion& c, const DraftProcess& process, const Node& node) {
    const std::vector<SecondPlace> reason{
        {fmt::format("\"{}\", a process in occam, is placed here", process.name), process.placed}};
    check_executes(c, node, reason);
}

} // namespace

void mark_code_nodes(Completion& c) {
    std::map<std::size_t, const DraftProcess*> code; // key: node; value: the first process in occam on this node
    for (std::size_t i = 0; i < c.draft.processes.size(); ++i)
        if (const DraftProcess& process = c.draft.processes[i];
            c.kinds[i] && c.kinds[i]->is_code && process.node != nowhere)
            code.try_emplace(process.node, &process);
    std::set<std::size_t> refused;
    for (std::size_t i = 0; i < c.draft.processes.size(); ++i)
        if (const DraftProcess& process = c.draft.processes[i]; !c.kinds[i] || !c.kinds[i]->is_code)
            if (const auto found = code.find(process.node); found != code.end() && refused.insert(process.node).second)
                c.reporter.error(process.placed,
                                 fmt::format("\"{}\" executes the occam process \"{}\", so \"{}\", which is not in "
                                             "occam, cannot be placed on it",
                                             c.network.nodes[process.node].name, found->second->name, process.name),
                                 "place one of the processes on another processor",
                                 {{fmt::format("\"{}\" is placed here", found->second->name), found->second->placed}});
    for (const auto& [node, process] : code) {
        check_code_type(c, *process, c.network.nodes[node]);
        c.network.nodes[node].runs_own_code = true;
    }
}

std::vector<bool> nodes_for_code(const Completion& c) {
    std::vector<bool> result;
    for (const Node& node : c.network.nodes)
        result.push_back(!node.runs_own_code && transputer::model_named(node.type));
    for (std::size_t i = 0; i < c.draft.processes.size(); ++i)
        if (const std::size_t node = c.draft.processes[i].node; node != nowhere)
            result[node] = c.kinds[i] && c.kinds[i]->is_code;
    return result;
}

namespace {

/// Returns the nodes through which a channel between processes in occam leads.
std::vector<std::size_t> nodes_between(const Network& network, const NetworkChannel& channel) {
    std::vector<std::size_t> nodes;
    const std::vector<RouteHop>& route = channel.placement.route;
    for (std::size_t i = 0; is_between_code(network, channel) && i + 1 < route.size(); ++i)
        nodes.push_back(end_of(route[i], network.connections).node);
    return nodes;
}

/// Refuses a channel between processes in C++ that leads through a node whose occam program passes on messages between
/// processes in occam.
void refuse_beside_relay(Completion& c, const NetworkChannel& channel, const NetworkChannel& relayed,
                         std::size_t node) {
    c.reporter.error(channel.connected,
                     fmt::format("the channels \"{}\" and \"{}\" lead through \"{}\", but it passes on only messages "
                                 "between processes in occam",
                                 channel.name, relayed.name, c.network.nodes[node].name),
                     "place one of the channels on other wires: place p.out on a.link[1];",
                     {{"the channel between processes in occam is connected here", relayed.connected}});
}

} // namespace

void complete_relays(Completion& c) {
    std::map<std::size_t, const NetworkChannel*>
        relays; // key: node; value: the first channel that leads through this node
    for (const NetworkChannel& channel : c.network.channels)
        for (const std::size_t node : nodes_between(c.network, channel))
            relays.try_emplace(node, &channel);
    for (const auto& [node, channel] : relays)
        if (!std::exchange(c.network.nodes[node].runs_own_code, true))
            check_executes(c, c.network.nodes[node],
                           {{fmt::format("the channel \"{}\" leads through it", channel->name), channel->connected}});
    for (const NetworkChannel& channel : c.network.channels)
        if (const std::vector<RouteHop>& route = channel.placement.route; !is_between_code(c.network, channel))
            for (std::size_t i = 0; i + 1 < route.size(); ++i)
                if (const auto found = relays.find(end_of(route[i], c.network.connections).node); found != relays.end())
                    return refuse_beside_relay(c, channel, *found->second, found->first);
}

namespace {

/// Checks the channels of processes in occam, and makes the images of their nodes. An image is the program that is in
/// the node's memory when the run begins.
class Images {
public:
    explicit Images(Completion& c) : c_(c), n_(c.network), has_code_(n_.nodes.size(), false) {
        for (const ProcessInstance& process : n_.processes)
            if (process.is_code)
                has_code_[process.node] = true;
        for (const NetworkChannel& channel : n_.channels)
            for (const std::size_t node : nodes_between(n_, channel))
                has_code_[node] = true;
    }

    void run() {
        for (const NetworkChannel& channel : n_.channels)
            if (leads_to_code(channel))
                check(channel);
        for (std::size_t i = 0; i < n_.nodes.size(); ++i)
            if (has_code_[i])
                check_host(i);
        for (std::size_t i = 0; i < n_.nodes.size() && !c_.reporter.failed(); ++i)
            if (has_code_[i])
                make(i);
    }

private:
    bool is_code(const ChannelEnd& end) const { return !end.at_edge() && n_.processes[end.process].is_code; }
    bool leads_to_code(const NetworkChannel& channel) const { return is_code(channel.from) || is_code(channel.to); }

    void check(const NetworkChannel& channel) {
        if (channel.placement.kind == ChannelPlacement::Kind::soft)
            return;
        const std::vector<RouteHop>& route = channel.placement.route;
        if (channel.from.at_edge() || channel.to.at_edge())
            return c_.reporter.error(
                channel.connected,
                fmt::format("the channel \"{}\" joins a process in occam and an edge without a process", channel.name),
                leads_to_host(channel) ? "leave the connection out: a channel to the host needs none"
                                       : "connect the channel with a channel of a process");
        const auto is_wire = [&](const RouteHop& hop) {
            return !n_.connections[hop.connection].over_bus && !n_.connections[hop.connection].at_run_time;
        };
        if (const auto other = std::ranges::find_if_not(route, is_wire); other != route.end())
            c_.reporter.error(
                channel.connected,
                fmt::format("the channel \"{}\" of a process in occam must lead over a wire, not over {}", channel.name,
                            n_.connections[other->connection].over_bus ? "a bus"
                                                                       : "a switch that is set during the run"));
        else if (is_between_code(n_, channel))
            return;
        else if (route.size() > 1)
            refuse_way(channel);
        else if (channel.placement.in_packets)
            refuse_shared(channel);
    }

    /// Returns whether a channel to an edge leads from the process to a host.
    bool leads_to_host(const NetworkChannel& channel) const {
        const ChannelEnd& end = channel.from.at_edge() ? channel.to : channel.from;
        const PortDescription* port = c_.kinds[end.process]->port(base_name(end.port));
        return port && port->to_host;
    }

    void refuse_way(const NetworkChannel& channel) {
        std::vector<std::string> between;
        for (std::size_t i = 0; i + 1 < channel.placement.route.size(); ++i)
            between.push_back("\"" + n_.nodes[end_of(channel.placement.route[i], n_.connections).node].name + "\"");
        const std::string from = n_.nodes[channel.from.node].name, to = n_.nodes[channel.to.node].name;
        c_.reporter.error(channel.connected,
                          fmt::format("the channel \"{}\" leads from \"{}\" to \"{}\" through {}, but a channel "
                                      "between a process in occam and a process in C++ needs a wire of its own",
                                      channel.name, from, to, fmt::join(between, ", ")),
                          "connect the two processors, or let a process in occam pass the messages on");
    }

    /// Reports, once for each pair of nodes, that too few wires lead from one node to the other for the channels
    /// between them.
    void refuse_shared(const NetworkChannel& channel) {
        const std::pair nodes(channel.from.node, channel.to.node);
        if (!refused_.insert(nodes).second)
            return;
        std::vector<std::string> channels, wires;
        for (const NetworkChannel& each : n_.channels)
            if (std::pair(each.from.node, each.to.node) == nodes)
                channels.push_back(each.name);
        for (const LinkConnection& wire : n_.connections)
            for (const auto& [a, b] : {std::pair(wire.a, wire.b), std::pair(wire.b, wire.a)})
                if (std::pair(a.node, b.node) == nodes && !wire.over_bus && !wire.at_run_time)
                    wires.push_back(link_name(n_.nodes, a));
        c_.reporter.error(
            channel.connected,
            fmt::format("{} lead from \"{}\" to \"{}\", but over only {}; a direction of a wire carries one channel "
                        "between a process in occam and a process in C++",
                        counted(channels.size(), "channel"), n_.nodes[nodes.first].name, n_.nodes[nodes.second].name,
                        counted(wires.size(), "wire")),
            fmt::format("the channels: {}; the wires: {}; channels between processes in occam can share wires",
                        fmt::join(channels, ", "), fmt::join(wires, ", ")));
    }

    /// Returns whether a port of the process leads to the host.
    bool uses_host_now(std::size_t process) const {
        const ProcessInstance& instance = n_.processes[process];
        return std::ranges::any_of(c_.kinds[process]->ports, [&](const PortDescription& port) {
            return port.to_host &&
                   std::ranges::find(instance.ports, port.name, &PortBinding::port) == instance.ports.end();
        });
    }

    void check_host(std::size_t node) {
        const ProcessInstance* first = nullptr;
        for (std::size_t i = 0; i < n_.processes.size(); ++i) {
            const ProcessInstance& process = n_.processes[i];
            if (process.node != node || !process.is_code || !uses_host_now(i))
                continue;
            if (!link_to_host(n_, node))
                return c_.reporter.error(
                    process.declared,
                    fmt::format("\"{}\" has channels to a host, but no host is connected to \"{}\"", process.name,
                                n_.nodes[node].name),
                    host_hint(node));
            if (first)
                return c_.reporter.error(
                    process.declared,
                    fmt::format("\"{}\" and \"{}\" use the host of \"{}\", which only one process can use", first->name,
                                process.name, n_.nodes[node].name),
                    "let the other processes send their output to this process",
                    {{"the first process is declared here", first->declared}});
            first = &process;
        }
    }

    std::string host_hint(std::size_t node) const {
        const std::string link = c_.free_link(node);
        return link.empty() ? "all links of the processor are taken" : fmt::format("connect {} to host;", link);
    }

    void make(std::size_t index) {
        Node& node = n_.nodes[index];
        node.image = c_.catalogue.files()->image(n_, index, c_.reporter);
        const auto memory = static_cast<std::uint64_t>(node.integer("memory"));
        if (node.image && node.image->bytes > memory)
            c_.reporter.error(node.declared,
                              fmt::format("the processes on \"{}\" need {} bytes of memory, but it has {}", node.name,
                                          node.image->bytes, memory),
                              fmt::format("{} (memory = {}K) ...;", node.type, (node.image->bytes + 1023) / 1024));
    }

    Completion& c_;
    Network& n_;
    std::vector<bool> has_code_;                            ///< for each node: whether it has an image
    std::set<std::pair<std::size_t, std::size_t>> refused_; ///< pairs of nodes that were reported
};

} // namespace

void complete_images(Completion& c) {
    if (c.catalogue.files())
        Images(c).run();
}

} // namespace placedpar
