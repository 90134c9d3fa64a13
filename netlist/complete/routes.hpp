#pragma once

#include "netlist/network/network.hpp"

#include <compare>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <vector>

namespace placedpar {

/// Compares routes by, in this order: the sum of the attribute `routecost` of the processors passed through, the number
/// of wires, the number of channels that these wires already carry in the same direction. Among routes of equal cost,
/// the search takes the route that leaves its processors, from the first on, by the lowest links.
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
/// on the route could not know when they are connected. The load of connection i is load[2 i] from b to a, load[2 i +
/// 1] from a to b. REQUIRES: all arguments outlive this object.
class RouteSearch {
public:
    RouteSearch(const std::vector<Node>& nodes, const std::vector<LinkConnection>& connections,
                const std::vector<std::size_t>& load);

    /// Returns the best route over at least one wire that avoids the nodes of `around`; nothing if there is none.
    std::optional<std::vector<RouteHop>> best(std::size_t from, std::size_t to,
                                              const std::set<std::size_t>& around = {});
    bool leads_through(std::size_t node) const { return leads_through_[node]; }
    /// Returns whether `linkquota` keeps some channel from leading through the node.
    bool is_kept_by_quota(std::size_t node) const;

private:
    /// Holds the least cost of a route between one node and each other node, without the load of wires; the cost is the
    /// same in both directions. A node without a route has no cost.
    using Least = std::vector<std::optional<RouteCost>>;

    struct Ends {
        std::size_t from, to; ///< nodes; not the same
    };
    /// Leads over a wire to the node at its other end.
    struct Step {
        RouteHop hop;
        std::size_t node;
    };

    /// Sets distances_ of the nodes through which a best route may lead. Searches all nodes except the nodes in
    /// `around`.
    void search_around(const Ends&, const std::set<std::size_t>& around);
    /// Searches only among the nodes on routes of least cost, without loads, if one of the two ends is a hub. Returns
    /// false if neither end is a hub.
    bool search_between(const Ends&);
    void search_among(const std::vector<std::size_t>& nodes, const Ends&);
    /// Lowers the distance of each predecessor of a node whose route over this node costs less, and then calls
    /// reach(cost, predecessor).
    template <class MayPass, class Reach>
    void reach_before(std::size_t node, const Ends&, MayPass may_pass, Reach reach);
    void forget_distances();
    /// Makes a node a hub when its searches have looked at more nodes than the network has, so that making the hub
    /// costs no more than these searches.
    void count_as_spent(std::size_t from, std::size_t to);
    void make_hub(std::size_t node);
    /// Returns the nodes on routes of the least cost, the farthest from the hub first, and marks them in within_.
    std::vector<std::size_t> nodes_between(const Least& least, std::size_t other);
    /// Returns whether a route that passes through the node where this hop begins (or ends) may take the hop.
    bool may_leave(const RouteHop&) const;
    bool may_come_in(const RouteHop& hop) const { return may_leave({hop.connection, !hop.from_a_to_b}); }
    RouteCost cost_of(const Step&, std::size_t to) const;

    const std::vector<Node>& nodes_;
    const std::vector<LinkConnection>& connections_;
    const std::vector<std::size_t>& load_;
    std::vector<std::vector<Step>> leaving_; ///< by node: the steps that leave it, the lowest link first
    std::vector<bool>
        beyond_quota_; ///< by 2 * connection + whether from a to b: the hop leaves its node by a link beyond the quota
    bool has_quotas_ = false; ///< some hop is beyond a quota, so the cost of a route may depend on its direction
    std::vector<bool> leads_through_;                 ///< by node
    std::vector<std::int64_t> routecost_;             ///< by node, for nodes that lead channels through
    std::vector<std::optional<RouteCost>> distances_; ///< by node: cost up to the end of the route that is searched
    std::vector<std::size_t> reached_;                ///< nodes that have a distance
    std::map<std::size_t, Least> hubs_;
    std::vector<std::size_t> spent_;    ///< by node: number of nodes visited by its searches before it became a hub
    std::vector<std::uint64_t> within_; ///< by node: number of the last search that was allowed to look at the node
    std::uint64_t searches_ = 0;        ///< number of searches that were restricted to some nodes
};

} // namespace placedpar
