#include "netlist/complete/stated_routes.hpp"

#include "netlist/language/syntax.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace placedpar {

namespace {

bool joins(const LinkConnection& wire, std::size_t one, std::size_t other) {
    return std::minmax(wire.a.node, wire.b.node) == std::minmax(one, other);
}

} // namespace

StatedRoutes::StatedRoutes(Completion& completion, const std::vector<std::size_t>& load)
    : c_(completion), wires_(completion.network.connections), load_(load) {
    for (std::size_t i = 0; i < wires_.size(); ++i)
        if (const auto& way = wires_[i].over_bus; way && way->wire != nowhere)
            ways_.emplace(way->wire, i);
}

std::vector<StatedRoute> StatedRoutes::wires(std::size_t channel) const {
    auto at_ends = by_ends(c_.network.channels[channel]);
    auto stated = by_connection(channel);
    return stated ? std::vector{*stated} : at_ends;
}

std::optional<StatedRoute> StatedRoutes::by_connection(std::size_t channel) const {
    auto draft = c_.draft_channel[channel];
    auto placed = c_.draft.connection_placements.find(draft == nowhere ? nowhere : c_.draft.channels[draft].connection);
    if (placed == c_.draft.connection_placements.end())
        return std::nullopt;
    const auto& [wire, at] = placed->second;
    auto found = c_.connection_named.find(wire);
    if (found == c_.connection_named.end())
        refuse(at, fmt::format("the connection \"{}\" connects no links", c_.draft.connections[wire].name));
    return StatedRoute{way_over_bus(found->second), nowhere, at};
}

std::vector<StatedRoute> StatedRoutes::by_ends(const NetworkChannel& channel) const {
    std::vector<StatedRoute> stated;
    for (const auto* end : {&channel.from, &channel.to}) {
        auto placed = c_.draft.placements.find({end->process, end->port});
        if (end->at_edge() || placed == c_.draft.placements.end())
            continue;
        if (end == &channel.to && placed->second.size() > 1)
            refuse(placed->second[1].at,
                   fmt::format("the route of the channel \"{}\" is stated at its input", channel.name),
                   "state the route at the output: place the output on each link by which the channel leaves a "
                   "processor");
        for (std::size_t i = 0; i < placed->second.size(); ++i) {
            StatedRoute here = wire_at({channel, *end, placed->second, i});
            bool again = end == &channel.to && !stated.empty() && stated.back().connection == here.connection;
            if (!again) // both ends may name the same wire
                stated.push_back(here);
        }
    }
    return stated;
}

StatedRoute StatedRoutes::wire_at(const StatedPlacement& place) const {
    StatedRoute stated{connection_at(place), nowhere, place.at()};
    if (std::size_t node = end_of_way(place.where()).node; !place.where().at_edge())
        stated.begin = place.inputs() ? other_end(stated.connection, node) : node;
    return stated;
}

std::size_t StatedRoutes::connection_at(const StatedPlacement& place) const {
    if (process_of(place).node == nowhere)
        throw StatementRefused{}; // already reported
    if (place.where().at_edge())
        return connection_to_edge(place);
    if (place.number == 0)
        require_own_link(place);
    if (place.where().link == bus_port)
        return way_from_bus(place);
    auto found = connection_at_link(place);
    return wires_[found].at_run_time ? connection_to_partner(place) : found;
}

/// Refuses the placement of a channel end on a link of another processor than the processor of its process.
void StatedRoutes::require_own_link(const StatedPlacement& place) const {
    const DraftProcess& process = process_of(place);
    if (end_of_way(place.where()).node != process.node)
        refuse(place.at(),
               fmt::format("the channel \"{}\" is placed on a link of \"{}\", but its process is on \"{}\"",
                           name_of(place), node_name(place.where().node), node_name(process.node)),
               "", {{"the process is placed here", process.placed}});
}

std::size_t StatedRoutes::connection_to_edge(const StatedPlacement& place) const {
    std::size_t edge = place.where().node, node = process_of(place).node;
    auto found = std::ranges::find_if(wires_, [&](const auto& wire) { return joins(wire, edge, node); });
    if (found == wires_.end())
        refuse(place.at(), fmt::format("the channel \"{}\" is placed on the edge \"{}\", but \"{}\" has no link to it",
                                       name_of(place), node_name(edge), node_name(node)));
    return static_cast<std::size_t>(found - wires_.begin());
}

std::size_t StatedRoutes::connection_at_link(const StatedPlacement& place) const {
    auto found = c_.connection_at.find({place.where().node, place.where().link});
    if (found != c_.connection_at.end())
        return way_over_bus(found->second);
    if (c_.wire_refused[place.where().node])
        throw StatementRefused{}; // already reported
    refuse(place.at(), fmt::format("the channel \"{}\" is placed on \"{}\", which is connected to nothing",
                                   name_of(place), link_of(place)));
}

/// Returns the connection that switches can make during the run from the stated link to the processor at the other end
/// of the channel.
std::size_t StatedRoutes::connection_to_partner(const StatedPlacement& place) const {
    const ChannelEnd& partner = place.inputs() ? place.channel.from : place.channel.to;
    auto stated = c_.draft.placements.find({partner.process, partner.port});
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < wires_.size(); ++i)
        for (auto [here, there] : {std::pair(wires_[i].a, wires_[i].b), std::pair(wires_[i].b, wires_[i].a)})
            if (here == place.where() && there.node == partner.node && !partner.at_edge()) {
                bool meant = stated != c_.draft.placements.end() && stated->second.front().where == there;
                found = found && !meant ? found : i;
            }
    if (!found && partner.node == nowhere)
        throw StatementRefused{}; // already reported
    if (!found)
        refuse(place.at(),
               fmt::format("the channel \"{}\" is placed on \"{}\", which no switch connects to a link of \"{}\"",
                           place.channel.name, link_of(place), node_name(partner.node)),
               "state the crosspoint that a program will set: connect sw.link[0] to sw.link[1];");
    return *found;
}

/// Returns the way over a bus, a path from a master to a slave, for a placement on the master's connector to the bus
/// (bus_port). If the placed end is an output, the way leads to the next stated place; if there is none, to the
/// receiver. If the placed end is an input, the way leads from the sender.
std::size_t StatedRoutes::way_from_bus(const StatedPlacement& place) const {
    bool last = place.number + 1 == place.all.size();
    auto other = place.inputs() ? place.channel.from.node
                 : last         ? place.channel.to.node
                                : end_of_way(place.all[place.number + 1].where).node;
    if (other == nowhere || c_.buses_refused)
        throw StatementRefused{}; // already reported
    auto found = way_between(place.where().node, other);
    if (!found)
        refuse(place.at(),
               fmt::format("the channel \"{}\" is placed on \"{}\", but no bus leads from there to \"{}\"",
                           name_of(place), link_of(place), node_name(other)),
               "a bus leads to the memory of bus masters, and through link adapters to processors");
    return *found;
}

/// Returns the way over a bus between two nodes: through the memory of a bus master if possible, otherwise over the
/// link adapter with the fewest channels.
std::optional<std::size_t> StatedRoutes::way_between(std::size_t one, std::size_t other) const {
    std::optional<std::size_t> best;
    auto cost = [&](std::size_t i) {
        return std::pair(wires_[i].over_bus->wire != nowhere, load_[2 * i] + load_[2 * i + 1]);
    };
    for (std::size_t i = 0; i < wires_.size(); ++i)
        if (wires_[i].over_bus && joins(wires_[i], one, other) && (!best || cost(i) < cost(*best)))
            best = i;
    return best;
}

/// If the wire is at a link adapter, returns the way over the bus that contains the wire; otherwise the wire itself.
std::size_t StatedRoutes::way_over_bus(std::size_t wire) const {
    auto way = ways_.find(wire);
    return way == ways_.end() ? wire : way->second;
}

/// If `placed` is the link of a link adapter, returns the master's end of the way over this adapter; otherwise
/// `placed`.
LinkEnd StatedRoutes::end_of_way(const LinkEnd& placed) const {
    auto wire = c_.connection_at.find({placed.node, placed.link});
    auto way = wire == c_.connection_at.end() ? ways_.end() : ways_.find(wire->second);
    bool at_adapter = way != ways_.end() && wires_[way->second].b != placed;
    return at_adapter ? wires_[way->second].a : placed;
}

std::size_t StatedRoutes::other_end(std::size_t connection, std::size_t node) const {
    const LinkConnection& wire = wires_[connection];
    return (wire.a.node == node ? wire.b : wire.a).node;
}

void StatedRoutes::refuse(const Location& at, std::string message, std::string hint,
                          std::vector<SecondPlace> others) const {
    c_.reporter.error(at, std::move(message), std::move(hint), std::move(others));
    throw StatementRefused{};
}

} // namespace placedpar
