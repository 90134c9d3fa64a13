#include "netlist/elaborate/elaborator.hpp"

#include <fmt/format.h>

namespace placedpar {

void Elaborator::perform(const PlaceStatement& form, const Location&) {
    auto found = find(form.what);
    if (found.category == Category::process)
        form.what.field.empty() ? place_process(form) : place_port(form);
    else if (found.category == Category::edge_channel)
        place_edge_channel(form);
    else if (found.category == Category::connection)
        place_connection(form);
    else
        refuse(form.what.at,
               fmt::format("\"{}\" is a node, which cannot be placed: place processes, channels and connections",
                           form.what.name));
}

void Elaborator::place_process(const PlaceStatement& form) {
    auto& process = draft_.processes[element(form.what, find(form.what))];
    auto where = find(form.where);
    if (where.category != Category::node)
        refuse(form.where.at,
               fmt::format("\"{}\" is not a processor: place the process on a processor", form.where.name));
    auto index = element(form.where, where);
    const auto& node = draft_.nodes[index];
    if (!form.where.field.empty())
        refuse(form.where.field_at, "a process cannot be placed on a link: place it on a processor");
    bool takes = node.kind->executes != Execution::none || node.kind->is_set_by_link();
    if (!takes && node.kind->links != LinkRole::edge) // a process on an edge turns the edge into a workstation
        refuse(form.where.at, fmt::format("\"{}\" is {}: no process can be placed on it", node.name, node.kind->noun));
    if (process.node != nowhere)
        refuse_placed_twice(form, "process", process.name, process.placed);
    process.node = index;
    process.placed = form.what.at;
}

void Elaborator::refuse_placed_twice(const PlaceStatement& form, const char* what, const std::string& name,
                                     const Location& first) {
    refuse(form.what.at, fmt::format("the {} \"{}\" is placed twice", what, name), "", {{"first placed here", first}});
}

void Elaborator::place_port(const PlaceStatement& form) {
    auto end = port_end(form.what, find(form.what));
    auto where = find(form.where);
    if (where.category != Category::node)
        refuse(form.where.at,
               fmt::format("\"{}\" is not a link: place the channel on a link, a bus or an edge", form.where.name));
    auto link = place_of_channel(form, where);
    auto& known = draft_.placements[{end.process, end.port}];
    auto tells_a_route = [&](const LinkEnd& at) { return !at.at_edge() && !draft_.nodes[at.node].kind->medium; };
    for (const auto& before : known)
        if (before.where.node == link.node || !tells_a_route(before.where) || !tells_a_route(link))
            refuse_placed_twice(form, "channel", draft_.processes[end.process].name + "." + end.port, before.at);
    known.push_back({link, form.what.at});
}

/// Returns where the channel is placed: on a link, on an edge, on a bus, or on the connector of a device to its bus.
LinkEnd Elaborator::place_of_channel(const PlaceStatement& form, const Found& found) {
    const Reference& where = form.where;
    const DeviceKind& kind = *draft_.nodes[found.first].kind;
    if (kind.medium && !kind.medium->broadcasts)
        refuse(where.at,
               fmt::format("\"{}\" is {}: a channel cannot be placed on the whole device", where.name, kind.noun),
               fmt::format("place {}.{} on the bus end of the sender's device, such as sun.bus[0]", form.what.name,
                           form.what.field));
    if (kind.medium && !where.field.empty())
        refuse(where.field_at, "a channel cannot be placed on a part of a bus: place it on the whole bus",
               fmt::format("place {}.{} on {};", form.what.name, form.what.field, where.name));
    if (kind.medium)
        return {element(where, found), bus_port};
    if (where.field != "bus")
        return link_end(where, found);
    if (kind.bus == BusRole::adapter)
        refuse(where.field_at,
               "a channel cannot be placed on the bus end of a link adapter: place it on the adapter's link",
               fmt::format("place {}.{} on {}.link[0];", form.what.name, form.what.field, where.name));
    bus_subscript(where, 0, 0);
    return {device_end(where, found), bus_port};
}

void Elaborator::place_edge_channel(const PlaceStatement& form) {
    auto& channel = draft_.edge_channels[port_end(form.what, find(form.what)).edge_channel];
    auto where = find(form.where);
    auto index = where.category == Category::node ? element(form.where, where) : nowhere;
    if (index == nowhere || draft_.nodes[index].kind->links != LinkRole::edge || !form.where.field.empty())
        refuse(form.where.at, fmt::format("\"{}\" is not an edge: place the edge channel on an edge", form.where.name),
               "the edge host is predefined");
    if (channel.edge != nowhere)
        refuse_placed_twice(form, "channel", channel.name, channel.placed);
    channel.edge = index;
    channel.placed = form.what.at;
}

void Elaborator::place_connection(const PlaceStatement& form) {
    auto where = find(form.where);
    if (where.category != Category::connection)
        refuse(form.where.at,
               fmt::format("\"{}\" is not a connection: place a connection of channels on a connection of links",
                           form.where.name));
    auto channel = element(form.what, find(form.what)), wire = element(form.where, where);
    auto [known, is_new] = draft_.connection_placements.emplace(channel, DraftConnectionPlacement{wire, form.what.at});
    if (!is_new)
        refuse_placed_twice(form, "connection", draft_.connections[channel].name, known->second.at);
}

} // namespace placedpar
