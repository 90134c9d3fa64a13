#include "gaprocs/merit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace placedpar {

namespace {

using Indices = std::vector<std::size_t>;

/// Returns whether `a` comes before `b` in the order by costs, or by violation. In this order each individual comes
/// before all individuals that it dominates.
bool comes_before(const Merit& a, const Merit& b) {
    if (a.feasible != b.feasible)
        return a.feasible;
    return a.feasible ? a.costs < b.costs : a.violation < b.violation;
}

void sort_by_costs(Indices& indices, std::span<const Merit> merits) {
    std::ranges::stable_sort(indices, [&](std::size_t a, std::size_t b) { return comes_before(merits[a], merits[b]); });
}

/// Moves the individuals that no other individual dominates out of `left`, and returns them. REQUIRES: `left` is sorted
/// by sort_by_costs().
Indices take_front(Indices& left, std::span<const Merit> merits) {
    Indices front, rest;
    for (std::size_t each : left) {
        bool dominated =
            std::ranges::any_of(front, [&](std::size_t other) { return dominates(merits[other], merits[each]); });
        (dominated ? rest : front).push_back(each);
    }
    left = std::move(rest);
    return front;
}

/// Adds the part of one cost to the crowding distance of each individual of the front. NSGA-II prefers individuals with
/// a large crowding distance. The part is the difference of the cost between the individual's two neighbours, divided
/// by the range of the cost in the front. The distance of the individuals with the lowest and the highest cost is
/// infinite. If the range is too large for a double, adds nothing to the distances of the other individuals.
void add_distances(const Indices& front, std::span<const Merit> merits, std::size_t cost,
                   std::vector<double>& distances) {
    Indices order = front;
    auto value = [&](std::size_t index) { return merits[index].costs[cost]; };
    std::ranges::stable_sort(order, {}, value);
    double range = value(order.back()) - value(order.front());
    for (std::size_t end : {order.front(), order.back()})
        distances[end] = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i + 1 < order.size() && range > 0 && std::isfinite(range); ++i)
        distances[order[i]] += (value(order[i + 1]) - value(order[i - 1])) / range;
}

Indices all_of(std::span<const Merit> merits) {
    Indices indices(merits.size());
    std::iota(indices.begin(), indices.end(), std::size_t{0});
    sort_by_costs(indices, merits);
    return indices;
}

} // namespace

bool dominates(const Merit& a, const Merit& b) {
    if (!a.feasible || !b.feasible)
        return comes_before(a, b);
    return a.costs != b.costs &&
           std::equal(a.costs.begin(), a.costs.end(), b.costs.begin(), [](double x, double y) { return x <= y; });
}

Indices front_of(std::span<const Merit> merits) {
    Indices all = all_of(merits);
    Indices front = take_front(all, merits);
    std::erase_if(front, [&](std::size_t each) { return !merits[each].feasible; });
    return front;
}

Indices order_of(std::span<const Merit> merits) {
    Indices left = all_of(merits), order;
    std::vector<double> distances(merits.size());
    while (!left.empty()) {
        Indices front = take_front(left, merits);
        const Merit& first = merits[front.front()];
        for (std::size_t cost = 0; first.feasible && cost < first.costs.size(); ++cost)
            add_distances(front, merits, cost, distances);
        std::ranges::sort(front);
        std::ranges::stable_sort(front, std::greater(), [&](std::size_t each) { return distances[each]; });
        order.insert(order.end(), front.begin(), front.end());
    }
    return order;
}

} // namespace placedpar
