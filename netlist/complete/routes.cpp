#include "netlist/complete/routes.hpp"

#include "netlist/kinds/device_kind.hpp"

#include <algorithm>
#include <functional>
#include <queue>
#include <utility>

namespace placedpar {

namespace {

constexpr std::size_t most_hubs =
    64; ///< largest number of hubs (see RouteSearch::search_between), our choice: each hub takes 32 bytes for each node

} // namespace

RouteSearch::RouteSearch(const std::vector<Node>& nodes, const std::vector<LinkConnection>& connections,
                         const std::vector<std::size_t>& load, const std::vector<bool>& may_pass)
    : nodes_(nodes), connections_(connections), load_(load), leaving_(nodes.size()),
      beyond_quota_(2 * connections.size(), false), leads_through_(nodes.size()), routecost_(nodes.size()),
      distances_(nodes.size()), spent_(nodes.size()), within_(nodes.size()) {
    for (std::size_t i = 0; i < connections.size(); ++i)
        for (RouteHop hop : {RouteHop{i, true}, RouteHop{i, false}})
            if (!connections[i].at_run_time)
                leaving_[begin_of(hop, connections).node].push_back({hop, end_of(hop, connections).node});
    for (auto& steps : leaving_)
        std::stable_sort(steps.begin(), steps.end(), [&](const Step& x, const Step& y) {
            return begin_of(x.hop, connections).link < begin_of(y.hop, connections).link;
        });
    for (std::size_t node = 0; node < nodes.size(); ++node)
        if (nodes[node].kind->passes_channels_on) {
            auto quota = static_cast<std::size_t>(nodes[node].integer("linkquota"));
            leads_through_[node] = quota >= 2 && may_pass[node];
            routecost_[node] = nodes[node].integer("routecost");
            for (std::size_t i = quota; i < leaving_[node].size(); ++i) {
                const RouteHop& hop = leaving_[node][i].hop;
                has_quotas_ = beyond_quota_[2 * hop.connection + (hop.from_a_to_b ? 1 : 0)] = true;
            }
        }
}

bool RouteSearch::is_kept_by_quota(std::size_t node) const {
    return nodes_[node].kind->passes_channels_on &&
           nodes_[node].integer("linkquota") < static_cast<std::int64_t>(leaving_[node].size());
}

bool RouteSearch::may_leave(const RouteHop& hop) const {
    return !beyond_quota_[2 * hop.connection + (hop.from_a_to_b ? 1 : 0)];
}

RouteCost RouteSearch::cost_of(const Step& step, std::size_t to) const {
    return {step.node == to ? 0 : routecost_[step.node], 1,
            load_[step.hop.connection * 2 + (step.hop.from_a_to_b ? 1 : 0)]};
}

void RouteSearch::forget_distances() {
    for (std::size_t node : reached_)
        distances_[node].reset();
    reached_.clear();
}

/// Computes the least cost from every node to the hub, a node at which many routes end, by Dijkstra's algorithm. Later
/// searches use the stored costs. REQUIRES: !has_quotas_.
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
        for (const auto& [hop, next] : leaving_[node])
            if (!least[next] || further < *least[next]) {
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

std::vector<std::size_t> RouteSearch::nodes_between(const Least& least, std::size_t other) {
    within_[other] = ++searches_;
    std::vector<std::size_t> nodes{other};
    for (std::size_t i = 0; i < nodes.size(); ++i)
        for (const auto& [hop, next] : leaving_[nodes[i]]) {
            if (within_[next] == searches_ || !least[next])
                continue;
            bool is_hub = least[next]->hops == 0;
            if (!(is_hub || leads_through(next)) ||
                *least[next] + RouteCost{is_hub ? 0 : routecost_[next], 1, 0} != *least[nodes[i]])
                continue;
            within_[next] = searches_;
            nodes.push_back(next);
        }
    auto is_farther = [&](std::size_t x, std::size_t y) { return *least[x] > *least[y]; };
    if (!std::ranges::is_sorted(nodes, is_farther)) // already sorted if all nodes have the same routecost
        std::ranges::sort(nodes, is_farther);
    return nodes;
}

template <class MayPass, class Reach>
void RouteSearch::reach_before(std::size_t node, const Ends& ends, MayPass may_pass, Reach reach) {
    const RouteCost cost = *distances_[node];
    for (const auto& [leaving, before] : leaving_[node]) {
        RouteHop hop{leaving.connection, !leaving.from_a_to_b}; // the same wire, towards the route's end
        if (before != ends.from && (!leads_through(before) || !may_pass(before) || !may_leave(hop)))
            continue;
        if (node != ends.to && !may_come_in(hop))
            continue;
        auto better = cost + cost_of({hop, node}, ends.to);
        if (!distances_[before])
            reached_.push_back(before);
        else if (better >= *distances_[before])
            continue;
        distances_[before] = better;
        reach(better, before);
    }
}

/// Searches by Dijkstra's algorithm, backwards from the end of the route.
void RouteSearch::search_around(const Ends& ends, const std::set<std::size_t>& around) {
    using Reached = std::pair<RouteCost, std::size_t>;
    std::priority_queue<Reached, std::vector<Reached>, std::greater<>> open;
    for (open.emplace(RouteCost{}, ends.to); !open.empty() && open.top().second != ends.from;) {
        auto [cost, node] = open.top();
        open.pop();
        if (distances_[node] == cost) // otherwise a cheaper route from the node has been found since
            reach_before(
                node, ends, [&](std::size_t before) { return !around.contains(before); },
                [&](const RouteCost& better, std::size_t before) { open.emplace(better, before); });
    }
}

void RouteSearch::search_among(const std::vector<std::size_t>& nodes, const Ends& ends) {
    for (std::size_t node : nodes)
        reach_before(
            node, ends, [&](std::size_t before) { return within_[before] == searches_; },
            [](const RouteCost&, std::size_t) {});
}

bool RouteSearch::search_between(const Ends& ends) {
    for (auto [hub, other] : {std::pair(ends.from, ends.to), std::pair(ends.to, ends.from)})
        if (auto found = hubs_.find(hub); found != hubs_.end()) {
            if (!found->second[other])
                return true;
            auto nodes = nodes_between(found->second, other);
            if (hub == ends.to)
                std::ranges::reverse(nodes);
            search_among(nodes, ends);
            return true;
        }
    return false;
}

std::optional<std::vector<RouteHop>> RouteSearch::best(std::size_t from, std::size_t to,
                                                       const std::set<std::size_t>& around) {
    if (from == to)
        return std::nullopt;
    forget_distances();
    reached_.push_back(to);
    distances_[to] = RouteCost{};
    if (!around.empty() || !search_between({from, to})) {
        search_around({from, to}, around);
        count_as_spent(from, to);
    }
    if (!distances_[from])
        return std::nullopt;
    std::vector<RouteHop> route;
    for (std::size_t node = from; node != to; node = end_of(route.back(), connections_).node) {
        auto leads_on = [&](const Step& step) {
            const auto& rest = distances_[step.node];
            bool allowed = (node == from || may_leave(step.hop)) && (step.node == to || may_come_in(step.hop));
            return rest && allowed && step.node != from && cost_of(step, to) + *rest == *distances_[node];
        };
        route.push_back(std::find_if(leaving_[node].begin(), leaving_[node].end(), leads_on)->hop);
    }
    return route;
}

} // namespace placedpar
