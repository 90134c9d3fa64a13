#include "netlist/print/pieces_as_wires.hpp"

#include <utility>

namespace placedpar {

namespace {

/// Renumbers connections for the drawing: first wires, then wires that end at switches (pieces), then ways over buses.
class Renumbering {
public:
    explicit Renumbering(const Network& network) : n_(network), place_(network.connections.size(), nowhere) {
        add([](const LinkConnection& each) { return !each.over_bus && !each.at_run_time; });
        first_piece_ = connections_.size();
        for (const WirePiece& piece : n_.pieces)
            connections_.push_back(wire_of(piece));
        add([](const LinkConnection& each) { return each.over_bus.has_value(); });
        for (LinkConnection& each : connections_)
            if (each.over_bus && each.over_bus->wire != nowhere)
                each.over_bus->wire = place_[each.over_bus->wire];
    }

    std::size_t place_of(std::size_t connection) const { return place_[connection]; }
    std::vector<LinkConnection> take() { return std::move(connections_); }

    void add_hops(const RouteHop& hop, std::vector<RouteHop>& route) const {
        const LinkConnection& connection = n_.connections[hop.connection];
        if (!connection.at_run_time)
            return route.push_back({place_[hop.connection], hop.from_a_to_b});
        std::vector<RouteHop> pieces;
        LinkEnd from = connection.a;
        for (const SwitchCrossing& crossing : connection.crossings) {
            pieces.push_back(piece_between(from, {crossing.node, crossing.from_link}));
            from = {crossing.node, crossing.to_link};
        }
        pieces.push_back(piece_between(from, connection.b));
        if (hop.from_a_to_b)
            route.insert(route.end(), pieces.begin(), pieces.end());
        else
            for (auto piece = pieces.rbegin(); piece != pieces.rend(); ++piece)
                route.push_back({piece->connection, !piece->from_a_to_b});
    }

private:
    template <class Wanted>
    void add(Wanted wanted) {
        for (std::size_t i = 0; i < n_.connections.size(); ++i)
            if (wanted(n_.connections[i])) {
                place_[i] = connections_.size();
                connections_.push_back(n_.connections[i]);
            }
    }

    LinkConnection wire_of(const WirePiece& piece) const {
        LinkConnection wire;
        wire.a = piece.a;
        wire.b = piece.b;
        wire.name = piece.name;
        wire.metres = piece.metres;
        wire.at_run_time = true;
        for (const LinkConnection& each : n_.connections)
            for (const LinkEnd& end : {each.a, each.b})
                if (each.at_run_time && (end == piece.a || end == piece.b))
                    wire.bits_per_second = each.bits_per_second;
        wire.bits_per_second = piece.bits_per_second.value_or(wire.bits_per_second);
        return wire;
    }

    RouteHop piece_between(const LinkEnd& from, const LinkEnd& to) const {
        std::size_t i = 0;
        while (i + 1 < n_.pieces.size() && n_.pieces[i].a != from && n_.pieces[i].b != from)
            ++i;
        return {first_piece_ + i, n_.pieces[i].b == to};
    }

    const Network& n_;
    std::vector<std::size_t>
        place_; ///< new index of each connection; nowhere for connections that switches make during the run
    std::vector<LinkConnection> connections_;
    std::size_t first_piece_ = 0;
};

} // namespace

Network with_pieces_as_wires(Network network) {
    if (network.pieces.empty())
        return network;
    Renumbering renumbering(network);
    for (NetworkChannel& channel : network.channels) {
        std::vector<RouteHop> route;
        for (const RouteHop& hop : channel.placement.route)
            renumbering.add_hops(hop, route);
        channel.placement.route = std::move(route);
    }
    for (Fault& fault : network.faults)
        if (fault.link >= 0 && renumbering.place_of(fault.connection) != nowhere)
            fault.connection = renumbering.place_of(fault.connection);
    network.connections = renumbering.take();
    return network;
}

} // namespace placedpar
