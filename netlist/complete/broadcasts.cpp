#include "netlist/complete/broadcasts.hpp"

#include "netlist/language/syntax.hpp"
#include "netlist/network/names.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace placedpar {

const DraftPlacement* Broadcasts::placement_of(const ChannelEnd& end) const {
    if (end.at_edge())
        return nullptr;
    auto found = c_.draft.placements.find({end.process, end.port});
    return found == c_.draft.placements.end() ? nullptr : &found->second.front();
}

std::optional<Broadcasts::Placed> Broadcasts::placed(const NetworkChannel& channel) const {
    for (const auto* end : {&channel.from, &channel.to})
        if (const auto* by = placement_of(*end); by != nullptr && c_.network.nodes[by->where.node].kind->medium)
            return Placed{*end, *by};
    return std::nullopt;
}

std::vector<std::size_t> Broadcasts::adapter_ways(std::size_t bus) const {
    std::vector<std::size_t> ways;
    for (std::size_t i = 0; i < c_.network.connections.size(); ++i)
        if (const auto& way = connection(i).over_bus; way && way->wire != nowhere && slave_of(connection(i)).bus == bus)
            ways.push_back(i);
    return ways;
}

bool Broadcasts::is_master(std::size_t node, std::size_t bus) const {
    return c_.network.nodes[node].kind->is_master() &&
           std::ranges::any_of(attachments(),
                               [&](const BusAttachment& each) { return each.node == node && each.bus == bus; });
}

RouteHop Broadcasts::way_of(const NetworkChannel& channel, const Placed& placed) const {
    require_output(channel, placed);
    if (channel.from.node == nowhere || channel.to.node == nowhere)
        throw StatementRefused{}; // already reported
    require_master(channel, placed);
    const DraftPlacement* stated = placement_of(channel.to);
    std::optional<std::size_t> best;
    auto cost = [&](std::size_t way) { return std::pair(load_[2 * way + 1], connection(way).b.link); };
    for (std::size_t way : adapter_ways(placed.bus()))
        if (const LinkConnection& each = connection(way);
            each.a.node == channel.from.node && each.b.node == channel.to.node &&
            (stated == nullptr || stated->where == each.b) && (!best || cost(way) < cost(*best)))
            best = way;
    if (!best)
        refuse_receiver(channel, placed);
    return {*best, true};
}

void Broadcasts::require_output(const NetworkChannel& channel, const Placed& placed) const {
    std::string what =
        fmt::format("the channel \"{}\" is placed on the bus \"{}\"", channel.name, node_name(placed.bus()));
    const char* leads = "a channel on a bus must lead from a process on a master of the bus to a process on a "
                        "processor at a link adapter of the bus";
    if (channel.from.at_edge() || channel.to.at_edge())
        refuse(placed.by.at, what + ", but one of its ends is at an edge", leads);
    if (&placed.end == &channel.from)
        return;
    bool from_master = channel.from.node != nowhere && is_master(channel.from.node, placed.bus());
    refuse(placed.by.at, what + " at its input, not at its output",
           from_master
               ? fmt::format("place its output: place {} on {};", end_name(channel.from), node_name(placed.bus()))
               : leads,
           {{"it is connected here", channel.connected}});
}

void Broadcasts::require_master(const NetworkChannel& channel, const Placed& placed) const {
    if (is_master(channel.from.node, placed.bus()))
        return;
    std::vector<std::string> masters;
    for (const BusAttachment& each : attachments())
        if (is_master(each.node, placed.bus()))
            masters.push_back(node_name(each.node));
    const DraftProcess& sender = c_.draft.processes[channel.from.process];
    refuse(placed.by.at,
           fmt::format("the channel \"{}\" is placed on the bus \"{}\", but its process \"{}\" is on \"{}\", which is "
                       "not a master of this bus",
                       channel.name, node_name(placed.bus()), sender.name, node_name(channel.from.node)),
           masters.empty() ? "the bus has no master; connect a workstation or a bus master to it"
                           : fmt::format("the masters of the bus are {}", fmt::join(masters, ", ")),
           {{"the process is placed here", sender.placed}});
}

void Broadcasts::refuse_receiver(const NetworkChannel& channel, const Placed& placed) const {
    if (c_.buses_refused)
        throw StatementRefused{}; // already reported
    const DraftProcess& receiver = c_.draft.processes[channel.to.process];
    const DraftPlacement* stated = placement_of(channel.to);
    std::vector<SecondPlace> others{{"the receiver is placed here", receiver.placed}};
    if (stated != nullptr)
        others.push_back(
            {fmt::format("its input is placed on {}", link_name(c_.network.nodes, stated->where)), stated->at});
    refuse(placed.by.at,
           fmt::format("the channel \"{}\" cannot be broadcast on the bus \"{}\": {}", channel.name,
                       node_name(placed.bus()), why_not(channel, placed.bus())),
           hint_at_adapters(channel, placed.bus()), std::move(others));
}

std::string Broadcasts::why_not(const NetworkChannel& channel, std::size_t bus) const {
    std::string receiver =
        fmt::format("\"{}\" is on \"{}\"", c_.draft.processes[channel.to.process].name, node_name(channel.to.node));
    if (channel.from.node == channel.to.node)
        return receiver + ", like the sender";
    for (std::size_t way : adapter_ways(bus))
        if (const LinkConnection& each = connection(way);
            each.b.node == channel.to.node && each.a.node != channel.from.node)
            return fmt::format("{}, but the link adapter \"{}\" that leads there belongs to \"{}\", not to \"{}\"",
                               receiver, node_name(slave_of(each).node), node_name(each.a.node),
                               node_name(channel.from.node));
    if (is_master(channel.to.node, bus))
        return receiver + ", which has memory on the bus, but no link adapter";
    return fmt::format("{}, {}", receiver,
                       placement_of(channel.to) ? "but no link adapter leads to the stated link"
                                                : "which no link adapter leads to");
}

/// Returns a hint that names the processors to which the sender's link adapters lead.
std::string Broadcasts::hint_at_adapters(const NetworkChannel& channel, std::size_t bus) const {
    constexpr std::size_t most = 4;
    std::vector<std::string> ends;
    for (std::size_t way : adapter_ways(bus))
        if (connection(way).a.node == channel.from.node)
            ends.push_back(link_name(c_.network.nodes, connection(way).b));
    std::string master = node_name(channel.from.node);
    if (ends.empty())
        return fmt::format("no link adapter of \"{}\" on \"{}\" leads to a processor", master, node_name(bus));
    bool more = ends.size() > most;
    ends.resize(std::min(ends.size(), most));
    return fmt::format("the link adapters of \"{}\" lead to {}{}", master, fmt::join(ends, ", "), more ? ", ..." : "");
}

void Broadcasts::check() const {
    std::map<std::size_t, std::vector<const NetworkChannel*>> out; // for each connection: channels from end a to end b
    for (const NetworkChannel& channel : c_.network.channels)
        for (const RouteHop& hop : channel.placement.route)
            if (hop.from_a_to_b)
                out[hop.connection].push_back(&channel);
    for (const NetworkChannel& channel : c_.network.channels)
        if (channel.placement.broadcast_on != nowhere)
            check(channel, out[channel.placement.route.front().connection]);
}

/// Reports a broadcast whose way over a bus also carries another channel. If the other channel is broadcast, too, one
/// error is enough: only the second of the two channels is reported.
void Broadcasts::check(const NetworkChannel& broadcast, const std::vector<const NetworkChannel*>& on_way) const {
    const NetworkChannel& other = *(on_way.front() == &broadcast ? on_way.back() : on_way.front());
    bool both = &other != &broadcast && other.placement.broadcast_on != nowhere;
    if (&other == &broadcast || (both && &other > &broadcast))
        return;
    const LinkConnection& way = connection(broadcast.placement.route.front().connection);
    bool same = both && are_one_broadcast(broadcast, other);
    c_.reporter.error(
        placed(broadcast)->by.at,
        fmt::format("the channel \"{}\" is broadcast over the link adapter \"{}\", which also carries \"{}\"",
                    broadcast.name, node_name(slave_of(way).node), other.name),
        same ? "a broadcast reaches each link adapter once: one process behind the adapter must input the message and "
               "pass it on"
             : "a link adapter of a broadcast carries no other outputs; place the other channel on another link",
        {{"the other channel is connected here", other.connected}});
}

void Broadcasts::refuse(const Location& at, std::string message, std::string hint,
                        std::vector<SecondPlace> others) const {
    c_.reporter.error(at, std::move(message), std::move(hint), std::move(others));
    throw StatementRefused{};
}

} // namespace placedpar
