#include "netlist/complete/routes.hpp"

#include "netlist/kinds/device_kind.hpp"

#include <algorithm>
#include <utility>

namespace placedpar {

struct RouteSearch::Distances {
    std::vector<std::optional<RouteCost>> of;
};

RouteSearch::RouteSearch(const std::vector<Node>& nodes, const std::vector<LinkConnection>& connections,
                         const std::vector<std::size_t>& load)
    : nodes_(nodes), connections_(connections), load_(load), leaving_(nodes.size()),
      beyond_quota_(2 * connections.size(), false) {
    for (std::size_t i = 0; i < connections.size(); ++i)
        for (RouteHop hop : {RouteHop{i, true}, RouteHop{i, false}})
            if (!connections[i].at_run_time)
                leaving_[begin_of(hop, connections).node].push_back(hop);
    for (auto& hops : leaving_)
        std::stable_sort(hops.begin(), hops.end(), [&](const RouteHop& x, const RouteHop& y) {
            return begin_of(x, connections).link < begin_of(y, connections).link;
        });
    for (std::size_t node = 0; node < nodes.size(); ++node)
        if (nodes[node].kind->passes_channels_on)
            for (std::size_t i = static_cast<std::size_t>(nodes[node].integer("linkquota")); i < leaving_[node].size();
                 ++i)
                beyond_quota_[2 * leaving_[node][i].connection + (leaving_[node][i].from_a_to_b ? 1 : 0)] = true;
}

bool RouteSearch::leads_through(std::size_t node) const {
    return nodes_[node].kind->passes_channels_on && nodes_[node].integer("linkquota") >= 2;
}

bool RouteSearch::is_kept_by_quota(std::size_t node) const {
    return nodes_[node].kind->passes_channels_on &&
           nodes_[node].integer("linkquota") < static_cast<std::int64_t>(leaving_[node].size());
}

bool RouteSearch::may_leave(const RouteHop& hop) const {
    return !beyond_quota_[2 * hop.connection + (hop.from_a_to_b ? 1 : 0)];
}

RouteCost RouteSearch::cost_of(const RouteHop& hop, std::size_t to) const {
    std::size_t next = end_of(hop, connections_).node;
    return {next == to ? 0 : nodes_[next].integer("routecost"), 1,
            load_[hop.connection * 2 + (hop.from_a_to_b ? 1 : 0)]};
}

/// E. Dijkstra, from the end of the route. REQUIRES: `from` is not `to`.
RouteSearch::Distances RouteSearch::distances_to(std::size_t to, std::size_t from,
                                                 const std::set<std::size_t>& around) const {
    Distances distances{std::vector<std::optional<RouteCost>>(nodes_.size())};
    std::set<std::pair<RouteCost, std::size_t>> open{{RouteCost{}, to}};
    distances.of[to] = RouteCost{};
    while (!open.empty()) {
        auto [cost, node] = *open.begin();
        open.erase(open.begin());
        if (node == from)
            break;
        for (const RouteHop& leaving : leaving_[node]) {
            RouteHop hop{leaving.connection, !leaving.from_a_to_b}; // the same wire, towards the end
            std::size_t before = begin_of(hop, connections_).node;
            if (before != from && (!leads_through(before) || around.contains(before) || !may_leave(hop)))
                continue;
            if (node != to && !may_come_in(hop))
                continue;
            auto better = cost + cost_of(hop, to);
            auto& known = distances.of[before];
            if (known && *known <= better)
                continue;
            if (known)
                open.erase({*known, before});
            known = better;
            open.insert({better, before});
        }
    }
    return distances;
}

std::optional<std::vector<RouteHop>> RouteSearch::best(std::size_t from, std::size_t to,
                                                       const std::set<std::size_t>& around) const {
    auto distances = distances_to(to, from, around);
    if (from == to || !distances.of[from])
        return std::nullopt;
    std::vector<RouteHop> route;
    for (std::size_t node = from; node != to; node = end_of(route.back(), connections_).node) {
        auto leads_on = [&](const RouteHop& hop) {
            const auto& rest = distances.of[end_of(hop, connections_).node];
            bool allowed =
                (node == from || may_leave(hop)) && (end_of(hop, connections_).node == to || may_come_in(hop));
            return rest && allowed && end_of(hop, connections_).node != from &&
                   cost_of(hop, to) + *rest == *distances.of[node];
        };
        route.push_back(*std::find_if(leaving_[node].begin(), leaving_[node].end(), leads_on));
    }
    return route;
}

} // namespace placedpar
