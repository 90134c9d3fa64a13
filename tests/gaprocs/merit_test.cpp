#include "gaprocs/merit.hpp"

#include "runtime/random.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

using namespace placedpar;

namespace {

Merit costs(std::vector<double> each) { return {.feasible = true, .costs = std::move(each)}; }

/// Draws `count` merits of `many` costs each. Costs have few values, so that many are equal; one merit in five is
/// infeasible.
std::vector<Merit> random_merits(std::size_t count, std::size_t many, std::uint64_t seed) {
    RandomStream random(seed, "merits");
    std::vector<Merit> merits(count);
    for (Merit& merit : merits)
        if (random.below(5) > 0) {
            merit.feasible = true;
            for (std::size_t i = 0; i < many; ++i)
                merit.costs.push_back(random.below(12));
        }
    return merits;
}

bool dominated(const std::vector<Merit>& merits, std::size_t which) {
    return std::ranges::any_of(merits, [&](const Merit& other) { return dominates(other, merits[which]); });
}

/// Returns each merit's layer: how often all undominated merits must be removed before this merit is undominated.
std::vector<std::size_t> layers(const std::vector<Merit>& merits) {
    std::vector<std::size_t> layer(merits.size(), 0);
    for (bool changed = true; changed;) {
        changed = false;
        for (std::size_t i = 0; i < merits.size(); ++i)
            for (std::size_t j = 0; j < merits.size(); ++j)
                if (dominates(merits[j], merits[i]) && layer[i] <= layer[j]) {
                    layer[i] = layer[j] + 1;
                    changed = true;
                }
    }
    return layer;
}

} // namespace

TEST_CASE("a machine dominates machines that are worse in some cost and better in none, and infeasible machines") {
    CHECK(dominates(costs({1, 2}), costs({1, 3})));
    CHECK_FALSE(dominates(costs({1, 2}), costs({1, 2})));
    CHECK_FALSE(dominates(costs({1, 3}), costs({2, 2})));
    CHECK(dominates(costs({9, 9}), Merit{}));
    CHECK_FALSE(dominates(Merit{}, Merit{}));
    CHECK_FALSE(dominates(Merit{}, costs({9})));
}

TEST_CASE("the front consists of the machines that no other machine dominates") {
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        CAPTURE(seed);
        auto merits = random_merits(1 + seed, 1 + seed % 2, seed);
        std::vector<std::size_t> expected;
        for (std::size_t i = 0; i < merits.size(); ++i)
            if (merits[i].feasible && !dominated(merits, i))
                expected.push_back(i);
        std::vector<std::size_t> front = front_of(merits);
        CHECK(std::ranges::is_sorted(front, {}, [&](std::size_t i) { return merits[i].costs; }));
        std::ranges::sort(front);
        CHECK(front == expected);
    }
}

TEST_CASE("the order goes front by front") {
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        CAPTURE(seed);
        auto merits = random_merits(1 + seed, 1 + seed % 2, seed);
        std::vector<std::size_t> order = order_of(merits), layer = layers(merits), all = order;
        CHECK(std::ranges::is_sorted(order, {}, [&](std::size_t i) { return layer[i]; }));
        std::ranges::sort(all);
        for (std::size_t i = 0; i < all.size(); ++i)
            CHECK(all[i] == i);
    }
}

TEST_CASE("within a front the ends come first, then the machines farthest from their neighbours") {
    // The second merit's distance is (10 - 0) / 100 in each of its two costs, the third merit's (100 - 1) / 100.
    std::vector<Merit> merits{costs({0, 100}), costs({1, 99}), costs({10, 90}), costs({100, 0})};
    CHECK(order_of(merits) == std::vector<std::size_t>{0, 3, 2, 1});
    CHECK(order_of(std::vector<Merit>{costs({2}), costs({1}), Merit{}, costs({1})}) ==
          std::vector<std::size_t>{1, 3, 0, 2});
}

TEST_CASE("the costs of infeasible merits are not read, whatever they are") {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    std::vector<Merit> merits(40, {.feasible = false, .costs = {unknown, infinite}, .violation = infinite});
    std::vector<std::size_t> in_order(merits.size());
    std::iota(in_order.begin(), in_order.end(), std::size_t{0});
    for (std::size_t i = 1; i < merits.size(); i += 3)
        merits[i].costs = i % 2 == 0 ? std::vector<double>{} : std::vector<double>{9, -infinite};
    CHECK(order_of(merits) == in_order);
}

TEST_CASE("costs whose distance is not a finite number still have an order") {
    std::vector<Merit> merits;
    for (double cost : {-1.0, -0.9, 0.1, 0.5, 0.9, 1.0})
        merits.push_back(costs({cost * std::numeric_limits<double>::max(), -cost}));
    CHECK(order_of(merits) == std::vector<std::size_t>{0, 5, 2, 1, 3, 4});
}
