#include "netlist/elaborate/elaborator.hpp"
#include "text/nearest.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace placedpar {

void Elaborator::refuse_unknown_port(const DraftProcess& process, const Reference& reference) {
    refuse(reference.field_at, fmt::format("the process \"{}\" has no channel \"{}\"", process.name, reference.field),
           did_you_mean(reference.field, names_in(process.interface->ports)),
           {{"the process is declared here", process.declared}});
}

void Elaborator::perform(const ConnectStatement& form, const Location& at) {
    auto a = find(form.a), b = find(form.b);
    auto is_link = [](const Found& found) { return found.category == Category::node; };
    auto is_channel = [](const Found& found) {
        return found.category == Category::process || found.category == Category::edge_channel;
    };
    for (const auto& [found, reference] : {std::pair(&a, &form.a), std::pair(&b, &form.b)})
        if (found->category == Category::connection)
            refuse(reference->at,
                   fmt::format("\"{}\" is a connection, but only links and channels can be connected", reference->name),
                   "connect ... to ... by connection;");
    if (leads_to_bus(form.a, a) || leads_to_bus(form.b, b))
        connect_to_bus(form, a, b, at);
    else if (is_link(a) && is_link(b))
        connect_links(link_end(form.a, a), link_end(form.b, b), form, at);
    else if (is_channel(a) && is_channel(b))
        connect_channels(port_end(form.a, a), port_end(form.b, b), form, at);
    else
        refuse(form.b.at, "a link cannot be connected to a channel",
               "connect links to links and channels to channels; place a channel on a link");
}

std::size_t Elaborator::connection_for(const ConnectStatement& form, const Location& at) {
    if (!form.by)
        return nowhere;
    auto found = find(*form.by);
    if (found.category != Category::connection)
        refuse(form.by->at, fmt::format("\"{}\" is not a connection", form.by->name),
               "declare a connection: connection name;");
    auto index = element(*form.by, found);
    auto& connection = draft_.connections[index];
    if (connection.used)
        refuse(form.by->at, fmt::format("the connection \"{}\" is used twice", connection.name), "",
               {{"first used here", *connection.used}});
    connection.used = at;
    return index;
}

void Elaborator::use_link(const LinkEnd& end, const Reference& reference, bool crosspoint) {
    auto& used = crosspoint ? used_crosspoints_ : used_links_;
    auto [known, is_new] = used.emplace(std::pair(end.node, end.link), reference.at);
    if (is_new)
        return;
    if (crosspoint && draft_.nodes[end.node].kind->is_set_by_link())
        return crosspoints_again_.push_back({end, reference.at, known->second});
    refuse_link(end, reference.at, known->second, crosspoint);
}

void Elaborator::refuse_link(const LinkEnd& end, const Location& at, const Location& first, bool crosspoint) {
    auto what = end.at_edge() ? "edge" : crosspoint ? "crosspoint" : "link";
    refuse(at, fmt::format("the {} \"{}\" is connected twice", what, link_name(draft_.nodes, end)), "",
           {{"first connected here", first}});
}

void Elaborator::connect_links(LinkEnd a, LinkEnd b, const ConnectStatement& form, const Location& at) {
    if (a.at_edge() && b.at_edge())
        refuse(form.b.at, "two edges cannot be connected", "an edge is connected to a link of a processor");
    if (a.node == b.node && a.link == b.link)
        refuse(form.b.at, fmt::format("the link \"{}\" is connected to itself", link_name(draft_.nodes, a)));
    bool config = a.link == configuration_link || b.link == configuration_link;
    bool crosspoint = a.node == b.node && draft_.nodes[a.node].kind->links == LinkRole::crosses && !config;
    if (config && (a.node == b.node || a.link == b.link))
        refuse(form.b.at, "a switch must be set by a processor, not by another switch",
               "connect root.link[3] to sw.config;");
    if (a.node == b.node && !crosspoint)
        refuse(form.b.at,
               fmt::format("two links of the same processor \"{}\" are connected", draft_.nodes[a.node].name),
               "a wire leads from one processor to another");
    auto pair = std::minmax(a.link, b.link);
    if (crosspoint && !crosspoints_.insert({a.node, pair.first, pair.second}).second)
        refuse_link(a, form.a.at, used_crosspoints_.at({a.node, a.link}), true);
    use_link(a, form.a, crosspoint);
    use_link(b, form.b, crosspoint);
    if (crosspoint && form.by)
        refuse(form.by->at, "a crosspoint of a switch is not a wire, so it has no connection");
    count_things(1, at);
    (crosspoint ? draft_.crosspoints : draft_.wires).push_back({a, b, connection_for(form, at), at});
}

/// Reports links with several crosspoints. They are allowed only if a wire leads to the switch's configuration link: a
/// program then sets the crosspoints.
void Elaborator::check_crosspoints() {
    for (const auto& [end, at, first] : crosspoints_again_)
        try {
            if (!used_links_.contains({end.node, configuration_link}))
                refuse_link(end, at, first, true);
        } catch (const StatementRefused&) {
            continue; // already reported
        }
}

void Elaborator::connect_channels(DraftChannelEnd a, DraftChannelEnd b, const ConnectStatement& form,
                                  const Location& at) {
    if (a.process == nowhere && b.process == nowhere)
        refuse(form.b.at, "two edge channels cannot be connected",
               "an edge channel is connected to a channel of a process");
    for (const auto* end : {&a, &b}) {
        if (end->process == nowhere) {
            auto& channel = draft_.edge_channels[end->edge_channel];
            if (channel.connected)
                refuse(end->at, fmt::format("the edge channel \"{}\" is connected twice", channel.name), "",
                       {{"first connected here", *channel.connected}});
            channel.connected = end->at;
            continue;
        }
        auto [known, is_new] = used_ports_.emplace(std::pair(end->process, end->port), end->at);
        if (!is_new)
            refuse(
                end->at,
                fmt::format("the channel \"{}.{}\" is connected twice", draft_.processes[end->process].name, end->port),
                "", {{"first connected here", known->second}});
    }
    draft_.channels.push_back({std::move(a), std::move(b), connection_for(form, at), at});
}

} // namespace placedpar
