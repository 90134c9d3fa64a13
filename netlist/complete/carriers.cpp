#include "netlist/complete/complete.hpp"
#include "netlist/language/syntax.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace placedpar {

namespace {

/// Gives every channel what carries it. First those that the netlist places, in its order; then each of the
/// rest, in its order, takes of the wires between its two nodes the one that the fewest channels use in its
/// direction, and of several the one with the lowest link at the sender.
class Carriers {
public:
    explicit Carriers(Completion& c) : c_(c), load_(c.network.connections.size() * 2, 0) {
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
                if (!place_as_told(i))
                    left.push_back(i);
            });
        for (auto i : left)
            attempt([&] { choose(i); });
        for (auto& channel : c_.network.channels)
            if (channel.placement.kind != ChannelPlacement::Kind::soft)
                channel.placement.shared = load(channel.placement) > 1;
    }

private:
    /// A step that refuses what it finds has reported why.
    template <class Step>
    static void attempt(Step step) {
        try {
            step();
        } catch (const StatementRefused&) {
            // the next channel is tried
        }
    }

    bool place_as_told(std::size_t index) {
        auto told_wire = told(index);
        if (told_wire)
            carry(c_.network.channels[index], told_wire->connection, told_wire->at);
        return told_wire.has_value();
    }

    std::size_t& load(const ChannelPlacement& carrier) {
        return load_[carrier.connection * 2 + (carrier.from_a_to_b ? 1 : 0)];
    }

    std::string node_name(std::size_t node) const { return c_.draft.nodes[node].name; }

    /// A wire that the netlist names for a channel, and where it does.
    struct Told {
        std::size_t connection;
        Location at;
    };

    /// What the netlist says about the wire: by one of the ends, or by `place c1 on c2`. Nothing where it says nothing.
    /// Throws StatementRefused after reporting an unusable placement.
    std::optional<Told> told(std::size_t index) {
        auto by_end = told_by_ends(c_.network.channels[index]);
        auto by_connection = told_by_connection(index);
        return by_connection ? by_connection : by_end;
    }

    std::optional<Told> told_by_ends(const NetworkChannel& channel) {
        std::optional<Told> told;
        for (const auto* end : {&channel.from, &channel.to}) {
            auto placed = c_.draft.placements.find({end->process, end->port});
            if (end->at_edge() || placed == c_.draft.placements.end())
                continue;
            Told here{connection_placed(*end, placed->second), placed->second.at};
            if (told && told->connection != here.connection)
                refuse(here.at, fmt::format("the two ends of the channel \"{}\" are placed on different connections",
                                            channel.name));
            told = here;
        }
        return told;
    }

    std::optional<Told> told_by_connection(std::size_t index) {
        auto draft = c_.draft_channel[index];
        auto placed =
            c_.draft.connection_placements.find(draft == nowhere ? nowhere : c_.draft.channels[draft].connection);
        if (placed == c_.draft.connection_placements.end())
            return std::nullopt;
        const auto& [wire, at] = placed->second;
        auto found = c_.connection_named.find(wire);
        if (found == c_.connection_named.end())
            refuse(at, fmt::format("the connection \"{}\" wires no links", c_.draft.connections[wire].name));
        return Told{found->second, at};
    }

    [[noreturn]] void refuse(const Location& at, std::string message, std::string hint = "",
                             std::vector<SecondPlace> others = {}) {
        c_.reporter.error(at, std::move(message), std::move(hint), std::move(others));
        throw StatementRefused{};
    }

    std::size_t connection_placed(const ChannelEnd& end, const DraftPlacement& placement) {
        const auto& process = c_.draft.processes[end.process];
        if (process.node == nowhere)
            throw StatementRefused{}; // reported
        auto channel = process.name + "." + end.port;
        return placement.where.at_edge() ? connection_to_edge(channel, process, placement)
                                         : connection_at_link(channel, process, placement);
    }

    std::size_t connection_to_edge(const std::string& channel, const DraftProcess& process,
                                   const DraftPlacement& placement) {
        auto found = between_.find({process.node, placement.where.node});
        if (found == between_.end())
            refuse(placement.at,
                   fmt::format("the channel \"{}\" is placed on the edge \"{}\", but \"{}\" has no link to it", channel,
                               node_name(placement.where.node), node_name(process.node)));
        return found->second.front();
    }

    std::size_t connection_at_link(const std::string& channel, const DraftProcess& process,
                                   const DraftPlacement& placement) {
        if (placement.where.node != process.node)
            refuse(placement.at,
                   fmt::format("the channel \"{}\" is placed on a link of \"{}\", but its process is on \"{}\"",
                               channel, node_name(placement.where.node), node_name(process.node)),
                   "", {{"the process is placed here", process.placed}});
        auto found = c_.connection_at.find({placement.where.node, placement.where.link});
        if (found == c_.connection_at.end() && c_.wire_refused[placement.where.node])
            throw StatementRefused{}; // reported
        if (found == c_.connection_at.end())
            refuse(placement.at, fmt::format("the channel \"{}\" is placed on \"{}\", which is connected to nothing",
                                             channel, link_name(c_.draft.nodes, placement.where)));
        return found->second;
    }

    /// Lets a connection carry the channel, if it leads from one of its ends to the other.
    void carry(NetworkChannel& channel, std::size_t index, const Location& at) {
        const auto& connection = c_.network.connections[index];
        bool to_edge = channel.from.at_edge() || channel.to.at_edge();
        auto& outer = channel.from.at_edge() ? channel.from : channel.to;
        if (to_edge && outer.node == nowhere && (connection.a.at_edge() || connection.b.at_edge()))
            outer.node = connection.a.at_edge() ? connection.a.node : connection.b.node;
        auto from = channel.from.node, to = channel.to.node;
        if (from == nowhere || to == nowhere)
            return edge_missing(channel);
        bool forwards = connection.a.node == from && connection.b.node == to;
        if (!forwards && !(connection.b.node == from && connection.a.node == to))
            refuse_wire(channel, connection, at);
        channel.placement = {to_edge ? ChannelPlacement::Kind::edge : ChannelPlacement::Kind::link, index, forwards,
                             false};
        ++load(channel.placement);
    }

    [[noreturn]] void refuse_wire(const NetworkChannel& channel, const LinkConnection& connection, const Location& at) {
        refuse(at,
               fmt::format("the channel \"{}\" leads from \"{}\" to \"{}\", but is placed on a wire between \"{}\" and "
                           "\"{}\"",
                           channel.name, node_name(channel.from.node), node_name(channel.to.node),
                           node_name(connection.a.node), node_name(connection.b.node)),
               "", {{"the wire is connected here", connection.connected}});
    }

    void choose(std::size_t index) {
        auto& channel = c_.network.channels[index];
        if (channel.from.at_edge() || channel.to.at_edge())
            return choose_edge(channel);
        if (channel.from.node == nowhere || channel.to.node == nowhere || channel.from.node == channel.to.node)
            return; // reported, or soft
        auto found = between_.find({channel.from.node, channel.to.node});
        if (found == between_.end())
            return refuse_no_neighbours(channel);
        carry(channel, lightest(found->second, channel.from.node), channel.connected);
    }

    void choose_edge(NetworkChannel& channel) {
        const auto& inner = channel.from.at_edge() ? channel.to : channel.from;
        const auto& outer = channel.from.at_edge() ? channel.from : channel.to;
        if (inner.node == nowhere)
            return; // reported
        auto candidates = edges_of_[inner.node];
        if (outer.node != nowhere)
            std::erase_if(candidates, [&](std::size_t i) {
                const auto& connection = c_.network.connections[i];
                return connection.a.node != outer.node && connection.b.node != outer.node;
            });
        if (candidates.empty())
            return edge_missing(channel);
        auto sender = channel.from.at_edge() ? nowhere : inner.node;
        carry(channel, lightest(candidates, sender), channel.connected);
    }

    void edge_missing(const NetworkChannel& channel) {
        const auto& inner = channel.from.at_edge() ? channel.to : channel.from;
        const auto& outer = channel.from.at_edge() ? channel.from : channel.to;
        if (inner.node == nowhere || c_.wire_refused[inner.node])
            return; // reported
        auto edge = outer.node == nowhere ? "an edge" : fmt::format("the edge \"{}\"", node_name(outer.node));
        refuse(channel.connected,
               fmt::format("the edge channel \"{}\" cannot be reached: \"{}\" has no link to {}", outer.port,
                           node_name(inner.node), edge),
               way_to_edge(inner.node, outer.node));
    }

    /// What would connect them, as far as links are free.
    std::string way_to_edge(std::size_t node, std::size_t edge) const {
        for (const auto& connection : c_.network.connections)
            for (auto [near, far] : {std::pair(connection.a, connection.b), std::pair(connection.b, connection.a)})
                if (far.at_edge() && (edge == nowhere || far.node == edge))
                    return fmt::format("\"{}\" is connected to {}: place the process there", node_name(far.node),
                                       link_name(c_.draft.nodes, near));
        auto link = c_.free_link(node);
        return link.empty() ? fmt::format("all links of \"{}\" are taken: one of them must lead there", node_name(node))
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

    void refuse_no_neighbours(const NetworkChannel& channel) {
        auto from = channel.from.node, to = channel.to.node;
        if (c_.wire_refused[from] || c_.wire_refused[to])
            return; // the wire that may be missed was reported
        const auto &sender = c_.draft.processes[channel.from.process],
                   &receiver = c_.draft.processes[channel.to.process];
        refuse(channel.connected,
               fmt::format("the channel \"{}\" has no route: the processors \"{}\" and \"{}\" are not neighbours",
                           channel.name, node_name(from), node_name(to)),
               fmt::format("\"{}\" has {}; \"{}\" has {}; channels are not routed through other processors",
                           node_name(from), links_of(from), node_name(to), links_of(to)),
               {{fmt::format("\"{}\" is placed here", sender.name), sender.placed},
                {fmt::format("\"{}\" is placed here", receiver.name), receiver.placed}});
    }

    Completion& c_;
    std::vector<std::size_t> load_; ///< channels on each connection, b to a and a to b
    std::map<std::pair<std::size_t, std::size_t>, std::vector<std::size_t>> between_;
    std::map<std::size_t, std::vector<std::size_t>> edges_of_;
};

} // namespace

void complete_carriers(Completion& completion) { Carriers(completion).run(); }

} // namespace placedpar
