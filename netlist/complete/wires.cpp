#include "netlist/complete/complete.hpp"

#include "netlist/network/names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace placedpar {

namespace {

using Socket = std::pair<std::size_t, int>; ///< node and link

Socket socket(const LinkEnd& end) { return {end.node, end.link}; }

/// Returns for each link of a switch its crosspoints, the possible connections to other links, in the order of the
/// netlist. A link has several crosspoints only if a program sets the switch.
std::map<Socket, std::vector<std::size_t>> all_by_end(const std::vector<DraftWire>& crosspoints) {
    std::map<Socket, std::vector<std::size_t>> places;
    for (std::size_t i = 0; i < crosspoints.size(); ++i)
        for (const auto& end : {crosspoints[i].a, crosspoints[i].b})
            places[socket(end)].push_back(i);
    return places;
}

/// Returns the index of the wire at each link.
std::map<Socket, std::size_t> by_end(const std::vector<DraftWire>& wires) {
    std::map<Socket, std::size_t> places;
    for (std::size_t i = 0; i < wires.size(); ++i)
        for (const auto& end : {wires[i].a, wires[i].b})
            places.emplace(socket(end), i);
    return places;
}

/// Returns the name of the array of wires without a name: "wire", or, if the netlist has things of this name, the first
/// of "wire_2", "wire_3" and so on that it does not have. This is the rule of Elaborator::claim_name().
std::string name_of_unnamed_wires(const Completion& completion) {
    const Draft& draft = completion.draft;
    std::set<std::string_view> taken;
    const auto take = [&taken](const auto& things) {
        for (const auto& each : things)
            taken.insert(base_name(each.name));
    };
    take(completion.network.nodes), take(draft.connections), take(draft.processes), take(draft.edge_channels);
    std::string name = "wire";
    for (int number = 2; taken.contains(name); ++number)
        name = fmt::format("wire_{}", number);
    return name;
}

/// Returns the name by which the option --set refers to each wire. Elaborator::name_wires() gives these names to wires
/// that the netlist does not name.
std::vector<std::string> names_for_set(const Completion& completion) {
    const Draft& draft = completion.draft;
    const std::string base = name_of_unnamed_wires(completion);
    std::vector<std::string> names;
    std::size_t without_name = 0;
    for (const DraftWire& wire : draft.wires)
        names.push_back(wire.connection == nowhere ? fmt::format("{}[{}]", base, without_name++)
                                                   : draft.connections[wire.connection].name);
    return names;
}

/// Joins wires through switches to connections between processors. At a switch that a program sets, follows every
/// crosspoint, since the program may make each of them during the run.
class Wiring {
public:
    explicit Wiring(Completion& completion)
        : c_(completion), wire_at_(by_end(c_.draft.wires)), crosspoints_at_(all_by_end(c_.draft.crosspoints)),
          names_for_set_(names_for_set(c_)) {}

    void run() {
        for (std::size_t i = 0; i < c_.draft.wires.size(); ++i)
            follow(i);
    }

private:
    static constexpr std::size_t most_ways = 20'000;

    bool at_switch(const LinkEnd& end) const {
        return c_.network.nodes[end.node].kind->links == LinkRole::crosses && end.link != configuration_link;
    }

    bool set_at_run_time(std::size_t node) const { return wire_at_.contains({node, configuration_link}); }

    static LinkEnd other_end(const DraftWire& wire, const LinkEnd& end) {
        return socket(wire.a) == socket(end) ? wire.b : wire.a;
    }

    void follow(std::size_t first) {
        const auto& wire = c_.draft.wires[first];
        if (at_switch(wire.a) && at_switch(wire.b))
            return; // a wire between two switches is reached from a processor
        LinkConnection connection;
        connection.a = at_switch(wire.a) ? wire.b : wire.a;
        connection.b = other_end(wire, connection.a);
        connection.connected = wire.at;
        extend(std::move(connection), {first});
    }

    /// Extends the connection through switches until its far end is not at a switch, and adds it to the network.
    void extend(LinkConnection connection, std::vector<std::size_t> pieces) {
        while (at_switch(connection.b)) {
            auto crosspoints = crosspoints_at_.find(socket(connection.b));
            if (crosspoints == crosspoints_at_.end())
                return refuse_crosspoint(connection, connection.b);
            if (set_at_run_time(connection.b.node))
                return extend_by_each(connection, pieces, crosspoints->second);
            if (!cross(connection, pieces, crosspoints->second.front()))
                return;
        }
        if (pieces.front() <= pieces.back()) // otherwise the connection was added from its other end
            add(std::move(connection), pieces);
    }

    void extend_by_each(const LinkConnection& connection, const std::vector<std::size_t>& pieces,
                        const std::vector<std::size_t>& crosspoints) {
        for (auto crosspoint : crosspoints) {
            auto on = connection;
            auto pieces_on = pieces;
            on.at_run_time = true;
            if (ways_ == most_ways)
                return refuse_ways(connection);
            ++ways_;
            if (cross(on, pieces_on, crosspoint))
                extend(std::move(on), std::move(pieces_on));
        }
    }

    void refuse_ways(const LinkConnection& connection) {
        c_.reporter.error(connection.connected,
                          fmt::format("the switches can connect links in more than {} ways", most_ways),
                          "state only the crosspoints that a program will set");
    }

    /// Extends the connection through the switch at its far end and along the next wire. Returns false after reporting
    /// that there is no next wire. Also returns false if the next wire is already part of the connection.
    bool cross(LinkConnection& connection, std::vector<std::size_t>& pieces, std::size_t crosspoint) {
        auto reached = connection.b;
        auto leaves = other_end(c_.draft.crosspoints[crosspoint], reached);
        connection.crossings.push_back({reached.node, reached.link, leaves.link});
        auto next = wire_at_.find(socket(leaves));
        if (next == wire_at_.end())
            return leads_nowhere(connection, leaves, "no wire leaves the switch at this link",
                                 fmt::format("connect {} to ...;", link_name(c_.network.nodes, leaves)));
        if (std::ranges::find(pieces, next->second) != pieces.end())
            return false;
        pieces.push_back(next->second);
        connection.b = other_end(c_.draft.wires[next->second], leaves);
        return true;
    }

    bool leads_nowhere(const LinkConnection& connection, const LinkEnd& at, const std::string& why,
                       const std::string& hint) {
        c_.reporter.error(connection.connected,
                          fmt::format("the wire from \"{}\" ends at \"{}\": {}",
                                      link_name(c_.network.nodes, connection.a), link_name(c_.network.nodes, at), why),
                          hint);
        c_.wire_refused[connection.a.node] = true;
        return false;
    }

    /// Returns the links of the switch that have a wire but no crosspoint, in ascending order.
    std::vector<LinkEnd> open_links(std::size_t node) const {
        std::vector<LinkEnd> open;
        for (const auto& [end, wire] : wire_at_)
            if (end.first == node && end.second != configuration_link && !crosspoints_at_.contains(end))
                open.push_back({end.first, end.second});
        return open;
    }

    /// Refuses a wire at a switch without a crosspoint. If exactly two such wires end at the switch, suggests the
    /// crosspoint between them; both errors then have this hint.
    void refuse_crosspoint(const LinkConnection& connection, const LinkEnd& at) {
        auto open = open_links(at.node);
        auto name = [&](const LinkEnd& end) { return link_name(c_.network.nodes, end); };
        leads_nowhere(connection, at, "the switch has no crosspoint for this wire",
                      open.size() == 2
                          ? fmt::format("connect {} to {};", name(open[0]), name(open[1]))
                          : fmt::format("connect {} to {}.link[...];", name(at), c_.network.nodes[at.node].name));
    }

    void add(LinkConnection connection, const std::vector<std::size_t>& pieces) {
        if (connection.a.node == connection.b.node)
            return c_.reporter.error(
                connection.connected,
                fmt::format("two links of the same processor \"{}\" cannot be connected through a switch",
                            c_.network.nodes[connection.a.node].name));
        if (connection.a.at_edge() && connection.b.at_edge())
            return c_.reporter.error(connection.connected, "two edges cannot be connected, not even through a switch");
        std::optional<std::int64_t> speed;
        for (auto piece : pieces)
            if (auto named = c_.draft.wires[piece].connection; named != nowhere)
                if (!add_attributes(connection, speed, named))
                    return;
        connection.bits_per_second = speed ? *speed : speed_of_ends(connection);
        name_for_set(connection, pieces);
        if (connection.at_run_time)
            for (auto piece : pieces)
                note_piece(piece);
        for (const auto& end : {connection.a, connection.b})
            if (!end.at_edge())
                c_.connection_at.emplace(socket(end), c_.network.connections.size());
        c_.network.connections.push_back(std::move(connection));
    }

    void name_for_set(LinkConnection& connection, const std::vector<std::size_t>& pieces) const {
        for (auto piece : pieces)
            if (auto named = c_.draft.wires[piece].connection;
                named != nowhere && c_.draft.connections[named].bits_per_second)
                connection.names_for_set.push_back(names_for_set_[piece]);
        if (connection.names_for_set.empty())
            connection.names_for_set.push_back(names_for_set_[pieces.front()]);
    }

    void note_piece(std::size_t index) {
        if (!noted_.insert(index).second)
            return;
        const auto& wire = c_.draft.wires[index];
        WirePiece piece{wire.a, wire.b, "", {}, 0};
        if (wire.connection != nowhere) {
            const auto& attributes = c_.draft.connections[wire.connection];
            piece.name = attributes.name;
            piece.bits_per_second = attributes.bits_per_second;
            piece.metres = attributes.metres.value_or(0);
        }
        c_.network.pieces.push_back(std::move(piece));
    }

    /// Adds length and speed of one wire of the chain to the connection. If the wire states another speed than a
    /// preceding wire, reports an error and returns false.
    bool add_attributes(LinkConnection& connection, std::optional<std::int64_t>& speed, std::size_t named) {
        const auto& attributes = c_.draft.connections[named];
        if (attributes.level || attributes.release) {
            c_.reporter.error(connection.connected,
                              fmt::format("the attribute \"{}\" applies only to a connection to a bus",
                                          attributes.level ? "level" : "release"),
                              "use the connection in a statement such as connect sun.bus[0] to vme.slot[1] by ...;",
                              {{"declared here", attributes.declared}});
            c_.wire_refused[connection.a.node] = c_.wire_refused[connection.b.node] = true;
            return false;
        }
        c_.connection_named.emplace(named, c_.network.connections.size());
        if (connection.name.empty() && !connection.at_run_time)
            connection.name = attributes.name;
        connection.metres += attributes.metres.value_or(0);
        bool differs = speed && attributes.bits_per_second && *speed != *attributes.bits_per_second;
        if (differs)
            c_.reporter.error(attributes.declared, fmt::format("the pieces of one connection run at {} and {} bit/s",
                                                               *speed, *attributes.bits_per_second));
        speed = attributes.bits_per_second ? attributes.bits_per_second : speed;
        return !differs;
    }

    std::int64_t speed_of_ends(const LinkConnection& connection) {
        bool a_has = has_speed(connection.a), b_has = has_speed(connection.b);
        if (!a_has && !b_has)
            return LinkConnection{}.bits_per_second;
        if (!a_has)
            return link_speed(connection.b);
        auto speed = link_speed(connection.a);
        if (b_has && link_speed(connection.b) != speed)
            refuse_speeds(connection);
        return speed;
    }

    /// Returns false for an edge and for the link by which a switch is set: the speed of the other end applies.
    static bool has_speed(const LinkEnd& end) { return !end.at_edge() && end.link != configuration_link; }
    std::int64_t link_speed(const LinkEnd& end) const { return c_.network.nodes[end.node].integer("linkspeed"); }

    void refuse_speeds(const LinkConnection& connection) {
        const auto &a = c_.network.nodes[connection.a.node], &b = c_.network.nodes[connection.b.node];
        c_.reporter.error(connection.connected,
                          fmt::format("the links run at different speeds: {} at {} bit/s, {} at {} bit/s", a.name,
                                      link_speed(connection.a), b.name, link_speed(connection.b)),
                          "set both speeds by a connection: connection (linkspeed = 10M) c; connect ... by c;",
                          {{"declared here", a.declared}, {"declared here", b.declared}});
    }

    Completion& c_;
    std::map<Socket, std::size_t> wire_at_;
    std::map<Socket, std::vector<std::size_t>> crosspoints_at_;
    std::vector<std::string> names_for_set_; ///< of each wire of the draft
    std::set<std::size_t> noted_;            ///< wires that are already in Network::pieces
    std::size_t ways_ = 0; ///< number of paths tried through crosspoints that a program sets; at most most_ways
};

bool is_computer(const Node& node) { return node.kind->executes != Execution::none; }

void check_isolated(Completion& c) {
    std::vector<bool> wired(c.network.nodes.size(), false);
    for (const auto& connection : c.network.connections)
        wired[connection.a.node] = wired[connection.b.node] = true;
    for (const auto& attachment : c.draft.attachments)
        wired[attachment.node] = true;
    if (std::count_if(c.network.nodes.begin(), c.network.nodes.end(), is_computer) < 2)
        return;
    for (std::size_t i = 0; i < wired.size(); ++i)
        if (const auto& node = c.network.nodes[i]; !wired[i] && is_computer(node) && !c.wire_refused[i])
            c.reporter.error(node.declared, fmt::format("the processor \"{}\" is connected to nothing", node.name),
                             fmt::format("connect {}.link[0] to ...;", node.name));
}

} // namespace

void complete_wires(Completion& completion) {
    completion.wire_refused.assign(completion.network.nodes.size(), false);
    Wiring(completion).run();
    check_isolated(completion);
}

} // namespace placedpar
