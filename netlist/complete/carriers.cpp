#include "netlist/complete/broadcasts.hpp"
#include "netlist/complete/complete.hpp"
#include "netlist/complete/routes.hpp"
#include "netlist/complete/stated_routes.hpp"
#include "netlist/language/syntax.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace placedpar {

namespace {

/// Chooses what carries each channel: the memory of one processor, or a route over wires and buses. Channels that the
/// netlist places on links come first. Then each other channel takes the best route (RouteCost in routes.hpp). Both
/// groups keep the order of the netlist. Between neighbours, the best route is the wire with the fewest channels in
/// this direction; among equal wires, the wire with the lowest link number at the sender. A channel to or from an edge,
/// where the network ends, takes one wire.
class Carriers {
public:
    explicit Carriers(Completion& c)
        : c_(c), wires_(c.network.connections), load_(wires_.size() * 2, 0),
          search_(c.network.nodes, wires_, load_, nodes_without_code(c)), stated_(c, load_), broadcasts_(c, load_) {
        if (std::ranges::any_of(c_.network.processes, &ProcessInstance::is_code))
            search_for_code_.emplace(c.network.nodes, wires_, load_, nodes_for_code(c));
        for (std::size_t i = 0; i < c_.network.connections.size(); ++i) {
            const auto& connection = c_.network.connections[i];
            between_[{connection.a.node, connection.b.node}].push_back(i);
            between_[{connection.b.node, connection.a.node}].push_back(i);
            for (auto [inner, outer] : {std::pair(connection.a, connection.b), std::pair(connection.b, connection.a)})
                if (outer.at_edge())
                    edges_of_[inner.node].push_back(i);
        }
    }

    void run() {
        std::vector<std::size_t> left;
        for (std::size_t i = 0; i < c_.network.channels.size(); ++i)
            attempt([&] {
                if (!place_as_stated(i))
                    left.push_back(i);
            });
        for (auto i : left)
            attempt([&] { choose(i); });
        check_switched(c_);
        broadcasts_.check();
        for (auto& channel : c_.network.channels)
            channel.placement.in_packets =
                !is_between_code(c_.network, channel) && travels_in_packets(channel.placement.route);
        check_channels_to_code();
    }

private:
    /// Runs one step for one channel. If the step throws StatementRefused, it has already reported the error.
    template <class Step>
    static void attempt(Step step) {
        try {
            step();
        } catch (const StatementRefused&) {
            // continue with the next channel
        }
    }

    bool place_as_stated(std::size_t index) {
        auto& channel = c_.network.channels[index];
        if (auto placed = broadcasts_.placed(channel)) {
            broadcast(index, *placed);
            return true;
        }
        auto stated_wires = stated_.wires(index);
        if (stated_wires.empty())
            return false;
        if (channel.from.at_edge() || channel.to.at_edge())
            carry_to_edge(channel, stated_wires.front().connection, stated_wires.front().at);
        else
            carry(channel, route_over(channel, stated_wires));
        return true;
    }

    void broadcast(std::size_t index, const Broadcasts::Placed& placed) {
        auto& channel = c_.network.channels[index];
        if (auto by_connection = stated_.by_connection(index))
            refuse(by_connection->at, fmt::format("the channel \"{}\" is placed twice", channel.name), "",
                   {{"first placed here", placed.by.at}});
        carry(channel, {broadcasts_.way_of(channel, placed)});
        channel.placement.broadcast_on = placed.bus();
    }

    static std::vector<bool> nodes_without_code(const Completion& c) {
        std::vector<bool> result;
        for (const Node& node : c.network.nodes)
            result.push_back(!node.runs_own_code);
        return result;
    }

    /// Returns the search that finds routes for this channel. Channels between processes in occam may lead through
    /// other processors than channels between processes in C++.
    RouteSearch& search(const NetworkChannel& channel) {
        return is_between_code(c_.network, channel) ? *search_for_code_ : search_;
    }

    std::size_t& load(const RouteHop& hop) { return load_[hop.connection * 2 + (hop.from_a_to_b ? 1 : 0)]; }

    bool travels_in_packets(const std::vector<RouteHop>& route) {
        return route.size() > 1 || std::any_of(route.begin(), route.end(),
                                               [&](auto& hop) { return load(hop) > 1 && !is_shared(hop.connection); });
    }

    /// Returns whether the connection is a way over a bus, or over another shared medium, that can carry any number of
    /// channels without packets.
    bool is_shared(std::size_t connection) const {
        const auto& way = wires_[connection].over_bus;
        return way && c_.network.nodes[c_.network.attachments[way->master].bus].kind->medium->shares_ways;
    }

    std::string node_name(std::size_t node) const { return c_.network.nodes[node].name; }

    [[noreturn]] void refuse(const Location& at, std::string message, std::string hint = "",
                             std::vector<SecondPlace> others = {}) {
        c_.reporter.error(at, std::move(message), std::move(hint), std::move(others));
        throw StatementRefused{};
    }

    /// Places a channel to an edge, or to the machine code of a processor, on the connection. Refuses a connection that
    /// does not join the process at the other end of the channel to this edge or processor.
    void carry_to_edge(NetworkChannel& channel, std::size_t index, const Location& at) {
        const auto& connection = c_.network.connections[index];
        auto& outer = channel.from.at_edge() ? channel.from : channel.to;
        if (outer.node == nowhere && (connection.a.at_edge() || connection.b.at_edge()))
            outer.node = connection.a.at_edge() ? connection.a.node : connection.b.node;
        auto from = channel.from.node, to = channel.to.node;
        if (from == nowhere || to == nowhere)
            return edge_missing(channel);
        bool forwards = connection.a.node == from && connection.b.node == to;
        if (!forwards && !(connection.b.node == from && connection.a.node == to))
            refuse_wire(channel, connection, at);
        auto kind =
            c_.network.nodes[outer.node].runs_own_code ? ChannelPlacement::Kind::link : ChannelPlacement::Kind::edge;
        channel.placement = {kind, {{index, forwards}}};
        ++load(channel.placement.route.front());
    }

    /// Refuses two channels to the machine code of a processor on one direction of a wire. The code sends and receives
    /// only bytes, so that it could not tell the channels apart.
    void check_channels_to_code() {
        std::map<std::pair<std::size_t, bool>, const NetworkChannel*> first;
        for (const auto& channel : c_.network.channels)
            if (const ChannelEnd* end = channel.end_at_code(); end && !channel.placement.route.empty()) {
                const RouteHop& hop = channel.placement.route.front();
                auto [known, is_new] = first.try_emplace({hop.connection, hop.from_a_to_b}, &channel);
                if (!is_new)
                    c_.reporter.error(channel.connected,
                                      fmt::format("the channels \"{}\" and \"{}\" use the same direction of a wire to "
                                                  "\"{}\", but its program would receive both on one link",
                                                  known->second->name, channel.name, node_name(end->node)),
                                      "place one of the channels on another link to this processor",
                                      {{"the first channel is placed here", known->second->connected}});
            }
    }

    [[noreturn]] void refuse_wire(const NetworkChannel& channel, const LinkConnection& connection, const Location& at) {
        refuse(at,
               fmt::format("the channel \"{}\" leads from \"{}\" to \"{}\", but is placed on a wire between \"{}\" and "
                           "\"{}\"",
                           channel.name, node_name(channel.from.node), node_name(channel.to.node),
                           node_name(connection.a.node), node_name(connection.b.node)),
               "", {{"the wire is connected here", connection.connected}});
    }

    void carry(NetworkChannel& channel, std::vector<RouteHop> route) {
        for (const auto& hop : route)
            ++load(hop);
        channel.placement = {ChannelPlacement::Kind::link, std::move(route)};
    }

    /// Returns the best route that uses these wires in this order. If there is no such route, reports an error and
    /// throws StatementRefused.
    std::vector<RouteHop> route_over(const NetworkChannel& channel, const std::vector<StatedRoute>& wires) {
        if (channel.from.node == nowhere || channel.to.node == nowhere)
            throw StatementRefused{}; // already reported
        if (std::ranges::any_of(wires, [&](const StatedRoute& wire) { return wires_[wire.connection].at_run_time; }))
            return route_over_switch(channel, wires);
        std::vector<RouteHop> route;
        std::set<std::size_t> passed{channel.from.node};
        for (const auto& wire : wires) {
            bool last = &wire == &wires.back();
            auto on = way_on(channel, route, wire, passed);
            if (!on)
                refuse_route(channel, wires, wire);
            for (const auto& hop : *on)
                if (auto node = end_of(hop, wires_).node;
                    !passed.insert(node).second || (node == channel.to.node && !last))
                    refuse_route(channel, wires, wire);
            route.insert(route.end(), on->begin(), on->end());
        }
        auto here = end_of(route.back(), wires_).node;
        if (here == channel.to.node)
            return route;
        auto rest = search(channel).best(here, channel.to.node, passed);
        if (!rest || !search(channel).leads_through(here))
            refuse_route(channel, wires, wires.back());
        route.insert(route.end(), rest->begin(), rest->end());
        return route;
    }

    /// Returns the route of a channel over a connection that switches make during the run. The route is a single hop:
    /// such a connection must lead directly from the sender's processor to the receiver's processor.
    std::vector<RouteHop> route_over_switch(const NetworkChannel& channel, const std::vector<StatedRoute>& wires) {
        const auto& connection = wires_[wires.front().connection];
        bool forwards = connection.a.node == channel.from.node && connection.b.node == channel.to.node;
        bool backwards = connection.b.node == channel.from.node && connection.a.node == channel.to.node;
        for (const auto& wire : wires)
            if (wire.connection != wires.front().connection || (!forwards && !backwards))
                refuse(
                    wire.at,
                    fmt::format(
                        "the route of the channel \"{}\" mixes a link that is switched during the run with other wires",
                        channel.name),
                    "a channel over a link switched at run time must lead directly from the sender's processor "
                    "to the receiver's");
        return {{wires.front().connection, forwards}};
    }

    /// Returns a route over a connection that switches make during the run between the channel's two processors;
    /// nothing if there is none. Chooses the connection with the fewest channels.
    std::optional<std::vector<RouteHop>> way_over_switch(const NetworkChannel& channel) {
        std::optional<RouteHop> best;
        auto between = between_.find({channel.from.node, channel.to.node});
        if (between == between_.end())
            return std::nullopt;
        for (auto i : between->second)
            if (RouteHop hop{i, wires_[i].a.node == channel.from.node};
                wires_[i].at_run_time && (!best || load(hop) < load(*best)))
                best = hop;
        return best ? std::optional(std::vector{*best}) : std::nullopt;
    }

    /// Returns the continuation of `route` with the fewest hops that ends with `wire`. The continuation avoids the
    /// processors in `passed`. It may reach the receiver's processor only over `wire`.
    std::optional<std::vector<RouteHop>> way_on(const NetworkChannel& channel, const std::vector<RouteHop>& route,
                                                const StatedRoute& wire, const std::set<std::size_t>& passed) {
        auto here = route.empty() ? channel.from.node : end_of(route.back(), wires_).node;
        auto around = passed;
        around.insert(channel.to.node);
        std::optional<std::vector<RouteHop>> shortest;
        for (RouteHop hop : {RouteHop{wire.connection, true}, RouteHop{wire.connection, false}}) {
            auto begin = begin_of(hop, wires_).node, end = end_of(hop, wires_).node;
            if ((wire.begin != nowhere && wire.begin != begin) || begin == channel.to.node || passed.contains(end))
                continue;
            std::optional<std::vector<RouteHop>> way{std::vector<RouteHop>{}};
            if (begin != here)
                way = search(channel).leads_through(begin) ? search(channel).best(here, begin, around) : std::nullopt;
            if (!way ||
                std::any_of(way->begin(), way->end(), [&](auto& each) { return end_of(each, wires_).node == end; }))
                continue;
            way->push_back(hop);
            if (!shortest || way->size() < shortest->size())
                shortest = way;
        }
        return shortest;
    }

    /// Returns the links by which a channel leaves the processors of its route: "a.link[0], b.link[2]".
    std::string text_of(const std::vector<RouteHop>& route) const {
        std::string text;
        for (const auto& hop : route)
            text += (text.empty() ? "" : ", ") + link_name(c_.network.nodes, begin_of(hop, wires_));
        return text;
    }

    /// Refuses the wire that the netlist states, and suggests the route that the channel would take without the
    /// statement.
    [[noreturn]] void refuse_route(const NetworkChannel& channel, const std::vector<StatedRoute>& wires,
                                   const StatedRoute& wire) {
        const auto& connection = wires_[wire.connection];
        auto best = search(channel).best(channel.from.node, channel.to.node);
        std::vector<SecondPlace> places{{"the wire is connected here", connection.connected}};
        add_quotas(places, channel.from.node, channel.to.node);
        refuse(wire.at,
               fmt::format("the channel \"{}\" cannot lead from \"{}\" to \"{}\" over the wire between \"{}\" and "
                           "\"{}\"{}",
                           channel.name, node_name(channel.from.node), node_name(channel.to.node),
                           node_name(connection.a.node), node_name(connection.b.node),
                           &wire == wires.data() ? "" : ", after the wires that are stated before this wire"),
               fmt::format("a route passes each processor at most once, and only processors pass a channel on{}",
                           best ? "; the shortest route leads over " + text_of(*best) : ""),
               std::move(places));
    }

    void choose(std::size_t index) {
        auto& channel = c_.network.channels[index];
        if (channel.from.at_edge() || channel.to.at_edge())
            return choose_edge(channel);
        if (channel.from.node == nowhere || channel.to.node == nowhere || channel.from.node == channel.to.node)
            return; // already reported, or both processes are on one processor
        auto route = search(channel).best(channel.from.node, channel.to.node);
        if (!route)
            route = way_over_switch(channel);
        if (!route)
            return refuse_no_route(channel);
        carry(channel, *route);
    }

    void choose_edge(NetworkChannel& channel) {
        const auto& inner = channel.from.at_edge() ? channel.to : channel.from;
        const auto& outer = channel.from.at_edge() ? channel.from : channel.to;
        if (inner.node == nowhere)
            return; // already reported
        auto candidates = edges_of_[inner.node];
        if (outer.node != nowhere)
            std::erase_if(candidates, [&](std::size_t i) {
                const auto& connection = c_.network.connections[i];
                return connection.a.node != outer.node && connection.b.node != outer.node;
            });
        if (candidates.empty())
            return edge_missing(channel);
        auto sender = channel.from.at_edge() ? nowhere : inner.node;
        carry_to_edge(channel, lightest(candidates, sender), channel.connected);
    }

    void edge_missing(const NetworkChannel& channel) {
        const auto& inner = channel.from.at_edge() ? channel.to : channel.from;
        const auto& outer = channel.from.at_edge() ? channel.from : channel.to;
        if (inner.node == nowhere || c_.wire_refused[inner.node])
            return; // already reported
        auto edge = outer.node == nowhere ? "an edge" : fmt::format("the edge \"{}\"", node_name(outer.node));
        refuse(channel.connected,
               fmt::format("the edge channel \"{}\" cannot be reached: \"{}\" has no link to {}", outer.port,
                           node_name(inner.node), edge),
               way_to_edge(inner.node, outer.node));
    }

    /// Returns a hint about how to connect the node to the edge.
    std::string way_to_edge(std::size_t node, std::size_t edge) const {
        for (const auto& connection : c_.network.connections)
            for (auto [near, far] : {std::pair(connection.a, connection.b), std::pair(connection.b, connection.a)})
                if (far.at_edge() && (edge == nowhere || far.node == edge))
                    return fmt::format("\"{}\" is connected to {}: place the process on that processor",
                                       node_name(far.node), link_name(c_.network.nodes, near));
        auto link = c_.free_link(node);
        return link.empty() ? fmt::format("all links of \"{}\" are taken: connect one of its links to the edge "
                                          "instead",
                                          node_name(node))
                            : fmt::format("connect {} to {};", link, edge == nowhere ? "host" : node_name(edge));
    }

    std::size_t lightest(const std::vector<std::size_t>& candidates, std::size_t sender) {
        auto weight = [&](std::size_t i) {
            const auto& connection = c_.network.connections[i];
            bool forwards = sender == nowhere ? connection.a.at_edge() : connection.a.node == sender;
            auto link = forwards ? connection.a.link : connection.b.link;
            if (sender == nowhere) // from an edge: the receiver's link decides
                link = forwards ? connection.b.link : connection.a.link;
            return std::pair(load_[i * 2 + (forwards ? 1 : 0)], link);
        };
        return *std::min_element(candidates.begin(), candidates.end(),
                                 [&](std::size_t x, std::size_t y) { return weight(x) < weight(y); });
    }

    std::string links_of(std::size_t node) const {
        std::string text;
        for (const auto& connection : c_.network.connections)
            for (auto [near, far] : {std::pair(connection.a, connection.b), std::pair(connection.b, connection.a)})
                if (near.node == node)
                    text += fmt::format("{}link {} to {}", text.empty() ? "" : ", ", near.link, node_name(far.node));
        return text.empty() ? "no links" : text;
    }

    void refuse_no_route(const NetworkChannel& channel) {
        if (std::find(c_.wire_refused.begin(), c_.wire_refused.end(), true) != c_.wire_refused.end())
            return; // a refused wire may be the cause, and was reported
        auto from = channel.from.node, to = channel.to.node;
        const auto &sender = c_.draft.processes[channel.from.process],
                   &receiver = c_.draft.processes[channel.to.process];
        std::vector<SecondPlace> places{{fmt::format("\"{}\" is placed here", sender.name), sender.placed},
                                        {fmt::format("\"{}\" is placed here", receiver.name), receiver.placed}};
        add_quotas(places, from, to);
        if (is_between_code(c_.network, channel))
            add_obstacles(places, from, to);
        refuse(
            channel.connected,
            fmt::format("the channel \"{}\" has no route: no chain of wires through processors joins \"{}\" and \"{}\"",
                        channel.name, node_name(from), node_name(to)),
            fmt::format("\"{}\" has {}; \"{}\" has {}{}", node_name(from), links_of(from), node_name(to), links_of(to),
                        missing_wire(from, to)),
            std::move(places));
    }

    /// Adds a note for each processor, except `from` and `to`, whose attribute `linkquota` keeps routes away from some
    /// of its wired links.
    void add_quotas(std::vector<SecondPlace>& places, std::size_t from, std::size_t to) const {
        for (std::size_t node = 0; node < c_.network.nodes.size(); ++node)
            if (node != from && node != to && search_.is_kept_by_quota(node))
                places.push_back({fmt::format("\"{}\" passes channels on over only {} of its links (linkquota)",
                                              node_name(node), c_.network.nodes[node].integer("linkquota")),
                                  c_.network.nodes[node].declared});
    }

    /// Adds a note for each processor through which channels between processes in C++ could lead, but not channels
    /// between processes in occam.
    void add_obstacles(std::vector<SecondPlace>& places, std::size_t from, std::size_t to) {
        const std::vector<RouteHop> route = search_.best(from, to).value_or(std::vector<RouteHop>{});
        for (std::size_t i = 0; i + 1 < route.size(); ++i) {
            const std::size_t node = end_of(route[i], wires_).node;
            if (search_for_code_->leads_through(node))
                continue;
            const auto process = std::ranges::find(c_.draft.processes, node, &DraftProcess::node);
            if (process == c_.draft.processes.end())
                places.push_back(
                    {fmt::format("\"{}\" executes no code, so it cannot pass the channel on", node_name(node)),
                     c_.network.nodes[node].declared});
            else
                places.push_back(
                    {fmt::format("\"{}\" cannot pass the channel on: \"{}\", which is not in occam, is placed here",
                                 node_name(node), process->name),
                     process->placed});
        }
    }

    std::string missing_wire(std::size_t from, std::size_t to) const {
        auto here = c_.free_link(from), there = c_.free_link(to);
        return here.empty() || there.empty() ? "" : fmt::format("; connect {} to {};", here, there);
    }

    Completion& c_;
    const std::vector<LinkConnection>& wires_;
    std::vector<std::size_t>
        load_; ///< number of channels on each connection i: element 2 i from b to a, element 2 i + 1 from a to b
    RouteSearch search_;
    std::optional<RouteSearch> search_for_code_; ///< nothing if no process is in occam
    StatedRoutes stated_;
    Broadcasts broadcasts_;
    std::map<std::pair<std::size_t, std::size_t>, std::vector<std::size_t>> between_;
    std::map<std::size_t, std::vector<std::size_t>> edges_of_;
};

} // namespace

void complete_carriers(Completion& completion) { Carriers(completion).run(); }

} // namespace placedpar
