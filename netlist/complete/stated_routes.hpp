#pragma once

#include "netlist/complete/complete.hpp"

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace placedpar {

/// Describes a wire, or a way over a bus, that a statement of the netlist selects for a channel.
struct StatedRoute {
    std::size_t connection;
    std::size_t begin; ///< node at which the messages enter the connection; nowhere: either end
    Location at;
};

/// Finds the routes that the netlist states for channels. The statement `place p.out on t.link[1];` places an end of a
/// channel on a link; `place c1 on c2;` places the channel with the connection c1 on the wire with the connection c2.
/// All functions throw StatementRefused after reporting a placement that cannot be used.
class StatedRoutes {
public:
    /// `load` counts the channels on each connection: see RouteSearch (netlist/complete/routes.hpp). REQUIRES: the
    /// arguments outlive this object; Network::connections is complete.
    StatedRoutes(Completion&, const std::vector<std::size_t>& load);

    /// Returns the wires and ways that the netlist states for the channel, in order; empty if it states none.
    std::vector<StatedRoute> wires(std::size_t channel) const;
    /// Returns the wire that `place c1 on c2` states for the channel.
    std::optional<StatedRoute> by_connection(std::size_t channel) const;

private:
    struct StatedPlacement {
        const NetworkChannel& channel;
        const ChannelEnd& end;
        const std::vector<DraftPlacement>& all; ///< all placements of this end, in the order of the netlist
        std::size_t number;                     ///< index of the placement in `all`
        const DraftPlacement& placement() const { return all[number]; }
        const LinkEnd& where() const { return placement().where; }
        const Location& at() const { return placement().at; }
        bool inputs() const { return &end == &channel.to; }
    };

    std::vector<StatedRoute> by_ends(const NetworkChannel&) const;
    StatedRoute wire_at(const StatedPlacement&) const;
    std::size_t connection_at(const StatedPlacement&) const;
    void require_own_link(const StatedPlacement&) const;
    std::size_t connection_to_edge(const StatedPlacement&) const;
    std::size_t connection_at_link(const StatedPlacement&) const;
    std::size_t connection_to_partner(const StatedPlacement&) const;
    std::size_t way_from_bus(const StatedPlacement&) const;
    std::optional<std::size_t> way_between(std::size_t one, std::size_t other) const;
    std::size_t way_over_bus(std::size_t wire) const;
    LinkEnd end_of_way(const LinkEnd& placed) const;
    std::size_t other_end(std::size_t connection, std::size_t node) const;

    const DraftProcess& process_of(const StatedPlacement& place) const { return c_.draft.processes[place.end.process]; }
    std::string name_of(const StatedPlacement& place) const { return process_of(place).name + "." + place.end.port; }
    const std::string& node_name(std::size_t node) const { return c_.network.nodes[node].name; }
    std::string link_of(const StatedPlacement& place) const { return link_name(c_.network.nodes, place.where()); }
    [[noreturn]] void refuse(const Location&, std::string message, std::string hint = "",
                             std::vector<SecondPlace> others = {}) const;

    Completion& c_;
    const std::vector<LinkConnection>& wires_;
    const std::vector<std::size_t>& load_;
    std::map<std::size_t, std::size_t>
        ways_; ///< index of each way over a bus; key: index of the wire at the way's link adapter
};

} // namespace placedpar
