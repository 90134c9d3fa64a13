#pragma once

#include "netlist/network/network.hpp"

#include <compare>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <vector>

namespace placedpar {

/// Holds the cost of a route. Costs are compared member by member: first the sum of the attribute `routecost` of the
/// processors passed through, then the number of wires, then the number of channels that these wires already carry in
/// the same direction. If costs are equal, the links by which the routes leave their processors decide: at the first
/// difference, the lower link wins.
struct RouteCost {
    std::int64_t processors = 0;
    std::size_t hops = 0;
    std::size_t load = 0;

    RouteCost operator+(const RouteCost& other) const {
        return {processors + other.processors, hops + other.hops, load + other.load};
    }
    auto operator<=>(const RouteCost&) const = default;
};

/// Finds the best route over wires between two nodes, through processors that pass channels on. Such a processor uses
/// only the lowest `linkquota` of its wired links. Wires that switches connect during the run are left out: a processor
/// on the route could not know when they are connected. `may_pass` says for each node whether routes may lead through
/// it, if the node's kind and `linkquota` also allow this. `load` counts the channels on each connection i: load[2 i]
/// from b to a, load[2 i + 1] from a to b. REQUIRES: all arguments outlive this object.
class RouteSearch {
public:
    RouteSearch(const std::vector<Node>& nodes, const std::vector<LinkConnection>& connections,
                const std::vector<std::size_t>& load, const std::vector<bool>& may_pass);

    /// Returns the best route, of at least one wire, that avoids the nodes in `around`; nothing if no such route
    /// exists.
    std::optional<std::vector<RouteHop>> best(std::size_t from, std::size_t to,
                                              const std::set<std::size_t>& around = {});
    bool leads_through(std::size_t node) const { return leads_through_[node]; }
    /// Returns whether the node's `linkquota` excludes a wired link from routes through the node.
    bool is_kept_by_quota(std::size_t node) const;

private:
    /// Holds for each node the least cost of a route between this node and one fixed node. Loads are not counted, so
    /// the cost is equal in both directions. A node without a route has no cost.
    using Least = std::vector<std::optional<RouteCost>>;

    struct Ends {
        std::size_t from, to; ///< nodes; must differ
    };
    /// Describes a hop over a wire, and the node at which the hop ends.
    struct Step {
        RouteHop hop;
        std::size_t node;
    };

    /// Sets distances_ of the nodes through which a best route may lead. Searches all nodes except the nodes in
    /// `around`.
    void search_around(const Ends&, const std::set<std::size_t>& around);
    /// A hub is an end of many routes for which the least costs from all nodes are stored. If one of the two ends is a
    /// hub, searches only among the nodes on routes of least cost (loads not counted). Returns false if neither end is
    /// a hub.
    bool search_between(const Ends&);
    void search_among(const std::vector<std::size_t>& nodes, const Ends&);
    /// For each neighbour of `node`: if a route over `node` costs less than the neighbour's distance, lowers the
    /// distance and calls `reach(cost, neighbour)`.
    template <class MayPass, class Reach>
    void reach_before(std::size_t node, const Ends&, MayPass may_pass, Reach reach);
    void forget_distances();
    /// Adds the number of nodes that the last search visited to spent_ of both ends. An end becomes a hub when its
    /// searches have visited more nodes than the network has: making the hub costs no more than these searches did.
    void count_as_spent(std::size_t from, std::size_t to);
    void make_hub(std::size_t node);
    /// Returns the nodes on routes of least cost, sorted by distance from the hub, farthest first. Marks them in
    /// within_.
    std::vector<std::size_t> nodes_between(const Least& least, std::size_t other);
    /// A hop leaves its first node by one link, and comes in at its second node by another. These two functions return
    /// whether a route through that node may use the link.
    bool may_leave(const RouteHop&) const;
    bool may_come_in(const RouteHop& hop) const { return may_leave({hop.connection, !hop.from_a_to_b}); }
    RouteCost cost_of(const Step&, std::size_t to) const;

    const std::vector<Node>& nodes_;
    const std::vector<LinkConnection>& connections_;
    const std::vector<std::size_t>& load_;
    std::vector<std::vector<Step>> leaving_; ///< for each node: the steps that leave it, lowest link first
    std::vector<bool>
        beyond_quota_; ///< at 2 * connection + from_a_to_b: whether this hop leaves its node by a link beyond the quota
    bool has_quotas_ = false; ///< some link is beyond a quota, so the cost of a route may depend on its direction
    std::vector<bool> leads_through_;     ///< for each node: whether routes may lead through it
    std::vector<std::int64_t> routecost_; ///< for each node that passes channels on
    std::vector<std::optional<RouteCost>>
        distances_;                    ///< for each node: least cost found from here to the end of the route
    std::vector<std::size_t> reached_; ///< nodes that have a distance
    std::map<std::size_t, Least> hubs_;
    std::vector<std::size_t> spent_;    ///< for each node: number of nodes visited by searches from or to this node
    std::vector<std::uint64_t> within_; ///< for each node: number of the last restricted search that included the node
    std::uint64_t searches_ = 0;        ///< number of searches that were restricted to some nodes
};

} // namespace placedpar
