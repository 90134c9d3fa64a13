#pragma once

#include "netlist/network/network.hpp"

#include <compare>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <vector>

namespace placedpar {

/// What decides between routes, in this order: what the processors that they lead through ask for it (attribute
/// `routecost`), how many wires they take, how many channels these carry already in their direction. Of routes that are
/// equal in all of these the one that leaves its processors, from the first on, by the lowest links is taken.
struct RouteCost {
    std::int64_t processors = 0;
    std::size_t hops = 0;
    std::size_t load = 0;

    RouteCost operator+(const RouteCost& other) const {
        return {processors + other.processors, hops + other.hops, load + other.load};
    }
    auto operator<=>(const RouteCost&) const = default;
};

/// The best route over wires from node to node through processors that pass channels on, and there only by as many of
/// the wired links, the lowest, as the attribute `linkquota` says. What switches connect during
/// the run is none of them: a processor between could not know when it is connected. The load of connection i is
/// load[2 i] from b to a, load[2 i + 1] from a to b. REQUIRES: all outlive it.
class RouteSearch {
public:
    RouteSearch(const std::vector<Node>& nodes, const std::vector<LinkConnection>& connections,
                const std::vector<std::size_t>& load);

    /// Over at least one wire, and through none of the nodes of `around`. Nothing if there is none.
    std::optional<std::vector<RouteHop>> best(std::size_t from, std::size_t to,
                                              const std::set<std::size_t>& around = {});
    bool leads_through(std::size_t node) const { return leads_through_[node]; }
    /// Whether the attribute keeps some channel from leading through the node.
    bool is_kept_by_quota(std::size_t node) const;

private:
    /// What the routes between a node and each other cost at least, whatever wires carry; the same in both directions.
    /// Nothing for those between which there are none.
    using Least = std::vector<std::optional<RouteCost>>;

    struct Ends {
        std::size_t from, to; ///< nodes; not the same
    };
    /// Over a wire to the node behind it.
    struct Step {
        RouteHop hop;
        std::size_t node;
    };

    /// Sets distances_ of the nodes that a best route may lead through. Looks at all but those `around`.
    void search_around(const Ends&, const std::set<std::size_t>& around);
    /// Searches where one of the two ends is a hub: only among nodes on routes that cost least, loads left out. Returns
    /// false if neither end is a hub.
    bool search_between(const Ends&);
    void search_among(const std::vector<std::size_t>& nodes, const Ends&);
    /// Sets those of the nodes before one where it is at less over that one, and calls reach(cost, node) for each.
    template <class MayPass, class Reach>
    void reach_before(std::size_t node, const Ends&, MayPass may_pass, Reach reach);
    void forget_distances();
    /// Makes hubs of nodes whose searches have looked at more nodes than there are: each pays for itself.
    void count_as_spent(std::size_t from, std::size_t to);
    void make_hub(std::size_t node);
    /// Returns the nodes on routes of the least cost, the farthest from the hub first, and marks them in within_.
    std::vector<std::size_t> nodes_between(const Least& least, std::size_t other);
    /// The hop, on a route that passes through the node where it begins, or ends.
    bool may_leave(const RouteHop&) const;
    bool may_come_in(const RouteHop& hop) const { return may_leave({hop.connection, !hop.from_a_to_b}); }
    RouteCost cost_of(const Step&, std::size_t to) const;

    const std::vector<Node>& nodes_;
    const std::vector<LinkConnection>& connections_;
    const std::vector<std::size_t>& load_;
    std::vector<std::vector<Step>> leaving_; ///< each node, the lowest link first
    std::vector<bool> beyond_quota_;         ///< a hop that leaves a node: 2 * connection + whether from a to b
    bool has_quotas_ = false;                ///< any is: what a route costs may then depend on its direction
    std::vector<bool> leads_through_;        ///< each node
    std::vector<std::int64_t> routecost_;    ///< of each node that leads channels through
    std::vector<std::optional<RouteCost>> distances_; ///< of each node from the end of the route that is searched
    std::vector<std::size_t> reached_;                ///< nodes of which there is one
    std::map<std::size_t, Least> hubs_;
    std::vector<std::size_t> spent_;    ///< of each node: at so many nodes its searches have looked before it was a hub
    std::vector<std::uint64_t> within_; ///< of each node: the last search that was to look at it
    std::uint64_t searches_ = 0;        ///< that were kept within some nodes
};

} // namespace placedpar
