#include "netlist/complete/routes.hpp"

#include "netlist/kinds/device_kind.hpp"

#include <algorithm>
#include <functional>
#include <queue>
#include <utility>

namespace placedpar {

namespace {

constexpr std::size_t most_hubs = 64; ///< ours: each takes 32 bytes for each node

} // namespace

RouteSearch::RouteSearch(const std::vector<Node>& nodes, const std::vector<LinkConnection>& connections,
                         const std::vector<std::size_t>& load)
    : nodes_(nodes), connections_(connections), load_(load), leaving_(nodes.size()),
      beyond_quota_(2 * connections.size(), false), leads_through_(nodes.size()), routecost_(nodes.size()),
      distances_(nodes.size()), spent_(nodes.size()), within_(nodes.size()) {
    for (std::size_t i = 0; i < connections.size(); ++i)
        for (RouteHop hop : {RouteHop{i, true}, RouteHop{i, false}})
            if (!connections[i].at_run_time)
                leaving_[begin_of(hop, connections).node].push_back(hop);
    for (auto& hops : leaving_)
        std::stable_sort(hops.begin(), hops.end(), [&](const RouteHop& x, const RouteHop& y) {
            return begin_of(x, connections).link < begin_of(y, connections).link;
        });
    for (std::size_t node = 0; node < nodes.size(); ++node)
        if (nodes[node].kind->passes_channels_on) {
            auto quota = static_cast<std::size_t>(nodes[node].integer("linkquota"));
            leads_through_[node] = quota >= 2;
            routecost_[node] = nodes[node].integer("routecost");
            for (std::size_t i = quota; i < leaving_[node].size(); ++i)
                has_quotas_ = beyond_quota_[2 * leaving_[node][i].connection + (leaving_[node][i].from_a_to_b ? 1 : 0)] = true;
        }
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
    return {next == to ? 0 : routecost_[next], 1, load_[hop.connection * 2 + (hop.from_a_to_b ? 1 : 0)]};
}

void RouteSearch::forget_distances() {
    for (std::size_t node : reached_)
        distances_[node].reset();
    reached_.clear();
}

/// E. Dijkstra, over all wires. REQUIRES: no quota keeps a channel from a link.
void RouteSearch::make_hub(std::size_t hub) {
    using Reached = std::pair<RouteCost, std::size_t>;
    std::priority_queue<Reached, std::vector<Reached>, std::greater<>> open;
    Least& least = hubs_.emplace(hub, Least(nodes_.size())).first->second;
    least[hub] = RouteCost{};
    for (open.emplace(RouteCost{}, hub); !open.empty();) {
        auto [cost, node] = open.top();
        open.pop();
        if (least[node] != cost || (node != hub && !leads_through(node)))
            continue;
        RouteCost further = cost + RouteCost{node == hub ? 0 : routecost_[node], 1, 0};
        for (const RouteHop& hop : leaving_[node])
            if (std::size_t next = end_of(hop, connections_).node; !least[next] || further < *least[next]) {
                least[next] = further;
                open.emplace(further, next);
            }
    }
}

void RouteSearch::count_as_spent(std::size_t from, std::size_t to) {
    for (std::size_t node : {from, to})
        if ((spent_[node] += reached_.size()) > nodes_.size() && hubs_.size() < most_hubs && !has_quotas_)
            make_hub(node);
}

void RouteSearch::mark_between(const Least& least, std::size_t other) {
    within_[other] = ++searches_;
    for (std::vector<std::size_t> left{other}; !left.empty();) {
        std::size_t node = left.back();
        left.pop_back();
        for (const RouteHop& hop : leaving_[node]) {
            std::size_t next = end_of(hop, connections_).node;
            if (within_[next] == searches_ || !least[next])
                continue;
            bool is_hub = least[next]->hops == 0;
            if (!(is_hub || leads_through(next)) ||
                *least[next] + RouteCost{is_hub ? 0 : routecost_[next], 1, 0} != *least[node])
                continue;
            within_[next] = searches_;
            left.push_back(next);
        }
    }
}

bool RouteSearch::search_between(std::size_t to, std::size_t from) {
    for (auto [hub, other] : {std::pair(from, to), std::pair(to, from)})
        if (auto found = hubs_.find(hub); found != hubs_.end()) {
            if (found->second[other]) {
                mark_between(found->second, other);
                search(to, from, [&](std::size_t node) { return within_[node] == searches_; });
            }
            return true;
        }
    return false;
}

void RouteSearch::search_around(std::size_t to, std::size_t from, const std::set<std::size_t>& around) {
    search(to, from, [&](std::size_t node) { return !around.contains(node); });
}

/// E. Dijkstra, from the end of the route. REQUIRES: `from` is not `to`.
template <class MayPass>
void RouteSearch::search(std::size_t to, std::size_t from, MayPass may_pass) {
    using Reached = std::pair<RouteCost, std::size_t>;
    std::priority_queue<Reached, std::vector<Reached>, std::greater<>> open;
    auto reach = [&](std::size_t node, const RouteCost& cost) {
        if (!distances_[node])
            reached_.push_back(node);
        distances_[node] = cost;
        open.emplace(cost, node);
    };
    for (reach(to, {}); !open.empty() && open.top().second != from;) {
        auto [cost, node] = open.top();
        open.pop();
        if (distances_[node] != cost)
            continue; // it was reached at less since
        for (const RouteHop& leaving : leaving_[node]) {
            RouteHop hop{leaving.connection, !leaving.from_a_to_b}; // the same wire, towards the end
            std::size_t before = begin_of(hop, connections_).node;
            if (before != from && (!leads_through(before) || !may_pass(before) || !may_leave(hop)))
                continue;
            if (node != to && !may_come_in(hop))
                continue;
            auto better = cost + cost_of(hop, to);
            if (!distances_[before] || better < *distances_[before])
                reach(before, better);
        }
    }
}

std::optional<std::vector<RouteHop>> RouteSearch::best(std::size_t from, std::size_t to,
                                                       const std::set<std::size_t>& around) {
    forget_distances();
    if (from == to)
        return std::nullopt;
    if (!around.empty() || !search_between(to, from)) {
        search_around(to, from, around);
        count_as_spent(from, to);
    }
    if (!distances_[from])
        return std::nullopt;
    std::vector<RouteHop> route;
    for (std::size_t node = from; node != to; node = end_of(route.back(), connections_).node) {
        auto leads_on = [&](const RouteHop& hop) {
            const auto& rest = distances_[end_of(hop, connections_).node];
            bool allowed =
                (node == from || may_leave(hop)) && (end_of(hop, connections_).node == to || may_come_in(hop));
            return rest && allowed && end_of(hop, connections_).node != from &&
                   cost_of(hop, to) + *rest == *distances_[node];
        };
        route.push_back(*std::find_if(leaving_[node].begin(), leaving_[node].end(), leads_on));
    }
    return route;
}

} // namespace placedpar
