#pragma once

#include "netlist/network/network.hpp"

#include <compare>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <vector>

namespace placedpar {

/// Holds the cost of a route over wires; the route with the least cost is chosen. Costs are compared member by member.
/// First comes the sum of the attribute `routecost` of the processors passed through. Then comes the number of wires,
/// and last the number of channels that these wires already carry in the direction of the route. Between routes of
/// equal cost, the links by which they leave their processors decide: at the first difference, the lower link number
/// wins.
struct RouteCost {
    std::int64_t processors = 0;
    std::size_t hops = 0;
    std::size_t load = 0;

    RouteCost operator+(const RouteCost& other) const {
        return {processors + other.processors, hops + other.hops, load + other.load};
    }
    auto operator<=>(const RouteCost&) const = default;
};

/// Finds the best route over wires between two nodes, through processors that pass messages on. Such a processor uses
/// only its lowest wired links for this, as many as its attribute `linkquota` says. Connections that switches make
/// during the run are not used, since a processor on the route could not know when they exist. Routes lead through a
/// node only if its kind, its `linkquota` and its element of `may_pass` allow this. `load` counts the channels on each
/// connection i: load[2 i] from b to a, load[2 i + 1] from a to b. REQUIRES: all arguments outlive this object.
class RouteSearch {
public:
    RouteSearch(const std::vector<Node>& nodes, const std::vector<LinkConnection>& connections,
                const std::vector<std::size_t>& load, const std::vector<bool>& may_pass);

    /// Returns the best route that avoids the nodes in `around`. Returns nothing if there is none, or if `from` is
    /// `to`.
    std::optional<std::vector<RouteHop>> best(std::size_t from, std::size_t to,
                                              const std::set<std::size_t>& around = {});
    bool leads_through(std::size_t node) const { return leads_through_[node]; }
    /// Returns whether the node's `linkquota` excludes one of its wired links from routes through the node.
    bool is_kept_by_quota(std::size_t node) const;

private:
    /// Holds for each node the least cost of a route to one fixed node. Loads are not counted, so that a route has the
    /// same cost in both directions. A node without a route has no cost.
    using Least = std::vector<std::optional<RouteCost>>;

    struct Ends {
        std::size_t from, to; ///< nodes; must differ
    };
    /// Describes a hop over a wire, and the node at which the hop ends.
    struct Step {
        RouteHop hop;
        std::size_t node;
    };

    /// Computes distances_ by a search of all nodes except the nodes in `around`.
    void search_around(const Ends&, const std::set<std::size_t>& around);
    /// Computes distances_ by a faster search, if one of the two ends is a hub. A hub is a node at the end of many
    /// routes, for which the least costs from all nodes are stored (hubs_). Only nodes on routes of least cost are
    /// searched, where loads are not counted. Returns false if neither end is a hub.
    bool search_between(const Ends&);
    void search_among(const std::vector<std::size_t>& nodes, const Ends&);
    /// Lowers the distance of each neighbour from which a route over `node` costs less than this distance. Calls
    /// `reach(cost, neighbour)` for each of these neighbours.
    template <class MayPass, class Reach>
    void reach_before(std::size_t node, const Ends&, MayPass may_pass, Reach reach);
    void forget_distances();
    /// Adds the number of nodes that the last search visited to spent_ of both ends. An end becomes a hub when its
    /// searches have visited more nodes than the network has: making the hub takes no longer than these searches took.
    void count_as_spent(std::size_t from, std::size_t to);
    void make_hub(std::size_t node);
    /// Returns the nodes on routes of least cost between `other` and a hub, the farthest from the hub first. `least`
    /// has the costs to this hub. Marks the nodes in within_.
    std::vector<std::size_t> nodes_between(const Least& least, std::size_t other);
    /// Return whether the `linkquota` of the node where the hop begins (ends) allows routes through this node to use
    /// the hop's link there.
    bool may_leave(const RouteHop&) const;
    bool may_come_in(const RouteHop& hop) const { return may_leave({hop.connection, !hop.from_a_to_b}); }
    RouteCost cost_of(const Step&, std::size_t to) const;

    const std::vector<Node>& nodes_;
    const std::vector<LinkConnection>& connections_;
    const std::vector<std::size_t>& load_;
    std::vector<std::vector<Step>>
        leaving_;                     ///< for each node: the steps that begin there, in ascending order of its links
    std::vector<bool> beyond_quota_;  ///< element 2 * connection + from_a_to_b: whether this hop begins at a link that
                                      ///< the node's `linkquota` excludes
    bool has_quotas_ = false;         ///< some `linkquota` excludes a link; hubs are then not made
    std::vector<bool> leads_through_; ///< for each node: whether routes may lead through it
    std::vector<std::int64_t> routecost_; ///< for each node that passes channels on
    std::vector<std::optional<RouteCost>>
        distances_;                    ///< for each node: least cost found so far of a route to the destination
    std::vector<std::size_t> reached_; ///< nodes that have an element in distances_
    std::map<std::size_t, Least> hubs_;
    std::vector<std::size_t> spent_;    ///< for each node: number of nodes visited by searches from or to this node
    std::vector<std::uint64_t> within_; ///< for each node: number of the last restricted search that included the node
    std::uint64_t searches_ = 0;        ///< number of searches that were restricted to some nodes
};

} // namespace placedpar
