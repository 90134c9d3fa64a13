#include "text/rank_test.hpp"

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/normal.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace placedpar {

namespace {

/// The sums of the ranks of each group's figures, where the figures of all groups are ranked together.
struct RankSums {
    std::vector<double> sums, sizes; ///< one element for each group
    double size = 0;                 ///< number of all figures
    double ties = 0;                 ///< sum of t^3 - t over the sets of t equal figures
};

/// Computes the sums of ranks. Equal figures get the mean of their ranks.
RankSums rank_sums(const std::vector<std::vector<double>>& groups) {
    std::vector<std::pair<double, std::size_t>> all;
    RankSums ranks{.sums = std::vector<double>(groups.size()), .sizes = {}};
    for (std::size_t group = 0; group < groups.size(); ++group) {
        ranks.sizes.push_back(static_cast<double>(groups[group].size()));
        for (double figure : groups[group])
            all.emplace_back(figure, group);
    }
    std::ranges::sort(all);
    ranks.size = static_cast<double>(all.size());
    for (std::size_t begin = 0, end = 0; begin < all.size(); begin = end) {
        while (end < all.size() && all[end].first == all[begin].first)
            ++end;
        const auto equal = static_cast<double>(end - begin);
        ranks.ties += equal * equal * equal - equal;
        for (std::size_t i = begin; i < end; ++i)
            ranks.sums[all[i].second] += static_cast<double>(begin + end + 1) / 2;
    }
    return ranks;
}

/// Counts the orders of m figures of a first group and n figures of a second group. A pair has one figure of each
/// group. Element u of the result is the number of orders in which the greater figure belongs to the first group in
/// exactly u pairs. These numbers are the coefficients of the Gaussian binomial, the product over i = 1 .. m of (1 -
/// q^(n + i)) / (1 - q^i).
std::vector<double> orders_by_pairs(std::size_t m, std::size_t n) {
    std::vector<double> orders(m * n + 1);
    orders[0] = 1;
    for (std::size_t i = 1; i <= m; ++i) {
        for (std::size_t u = orders.size(); u-- > n + i;)
            orders[u] -= orders[u - n - i];
        for (std::size_t u = i; u < orders.size(); ++u)
            orders[u] += orders[u - i];
    }
    return orders;
}

/// Returns the two-sided probability, at most 1: twice the probability that the greater figure belongs to the first
/// group in at least `pairs` pairs.
double exact_p(std::size_t m, std::size_t n, double pairs) {
    const std::vector<double> orders = orders_by_pairs(m, n);
    double all = 0, extreme = 0;
    for (std::size_t u = 0; u < orders.size(); ++u) {
        all += orders[u];
        extreme += static_cast<double>(u) >= pairs ? orders[u] : 0;
    }
    return std::min(1.0, 2 * extreme / all);
}

double normal_p(const RankSums& ranks, double pairs) {
    const double product = ranks.sizes[0] * ranks.sizes[1], n = ranks.size;
    const double variance = product / 12 * (n + 1 - ranks.ties / (n * (n - 1)));
    if (!(variance > 0)) // all figures are equal
        return 1;
    const double z = (pairs - product / 2 - 0.5) / std::sqrt(variance);
    return std::min(1.0, 2 * boost::math::cdf(boost::math::complement(boost::math::normal_distribution<double>(), z)));
}

} // namespace

RankTest mann_whitney(const std::vector<double>& first, const std::vector<double>& second) {
    constexpr std::size_t most_counted = 40;
    const RankSums ranks = rank_sums({first, second});
    const double product = ranks.sizes[0] * ranks.sizes[1];
    const double greater = ranks.sums[0] - ranks.sizes[0] * (ranks.sizes[0] + 1) / 2;
    const double pairs = std::max(greater, product - greater);
    const bool exact = ranks.ties == 0 && first.size() + second.size() <= most_counted;
    return {.p = exact ? exact_p(first.size(), second.size(), pairs) : normal_p(ranks, pairs),
            .effect = greater / product,
            .exact = exact};
}

RankTest kruskal_wallis(const std::vector<std::vector<double>>& groups) {
    const RankSums ranks = rank_sums(groups);
    const double n = ranks.size, untied = 1 - ranks.ties / (n * n * n - n);
    if (!(untied > 0)) // all figures are equal
        return {.p = 1, .effect = 0};
    double squares = 0;
    for (std::size_t i = 0; i < groups.size(); ++i)
        squares += ranks.sums[i] * ranks.sums[i] / ranks.sizes[i];
    const double h = std::max(0.0, (12 / (n * (n + 1)) * squares - 3 * (n + 1)) / untied);
    const boost::math::chi_squared_distribution<double> chi_squared(static_cast<double>(groups.size() - 1));
    return {.p = boost::math::cdf(boost::math::complement(chi_squared, h)), .effect = h / (n - 1)};
}

} // namespace placedpar
