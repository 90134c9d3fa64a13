#pragma once

#include "netlist/complete/complete.hpp"

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace placedpar {

/// Describes a wire or a way over a bus that the netlist states for a channel, and the location of the statement.
struct StatedRoute {
    std::size_t connection;
    std::size_t begin; ///< node where the channel enters the connection; nowhere: the channel may enter at either end
    Location at;
};

/// Finds the routes that the netlist states for channels, by `place` statements for an end of a channel or for its
/// connection. All functions throw StatementRefused after reporting a placement that cannot be used.
class StatedRoutes {
public:
    /// REQUIRES: the arguments outlive this object, and the connections are complete. `load` has the layout of
    /// RouteSearch's `load`.
    StatedRoutes(Completion&, const std::vector<std::size_t>& load);

    /// Returns the stated wires of the channel in order; empty if the netlist states no wires.
    std::vector<StatedRoute> wires(std::size_t channel) const;
    /// Returns the wire that `place c1 on c2` states for the channel.
    std::optional<StatedRoute> by_connection(std::size_t channel) const;

private:
    struct StatedPlacement {
        const NetworkChannel& channel;
        const ChannelEnd& end;
        const std::vector<DraftPlacement>& all; ///< placements of this end
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
    std::map<std::size_t, std::size_t> ways_; ///< ways over buses; key: wire at the link adapter of the way
};

} // namespace placedpar
