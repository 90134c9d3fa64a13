#include "text/rank_test.hpp"

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/normal.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>

namespace placedpar {

namespace {

/// The sums of the ranks of each group's figures, where the figures of all groups are ranked together.
struct RankSums {
    std::vector<double> sums, sizes;       ///< one element for each group
    double size = 0;                       ///< number of all figures
    double ties = 0;                       ///< sum of t^3 - t over the sets of t equal figures
    std::vector<std::size_t> doubled = {}; ///< twice the rank of each figure, in ascending order
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
        ranks.doubled.insert(ranks.doubled.end(), end - begin, begin + end + 1);
    }
    return ranks;
}

/// Returns the two-sided probability that a group of m of these figures, chosen at random, has a sum of ranks at least
/// as far from its mean as `sum`. Ranks and sums are doubled, so that the mean rank of equal figures is an integer.
double exact_p(std::size_t m, const std::vector<std::size_t>& ranks, std::size_t sum) {
    const std::size_t most = std::accumulate(ranks.begin(), ranks.end(), std::size_t{0});
    std::vector<std::vector<double>> choices(m + 1, std::vector<double>(most + 1)); // by number of figures and sum
    choices[0][0] = 1;
    for (const std::size_t rank : ranks)
        for (std::size_t chosen = m; chosen > 0; --chosen)
            for (std::size_t with = most; with >= rank; --with)
                choices[chosen][with] += choices[chosen - 1][with - rank];
    const double mean = static_cast<double>(m * most) / static_cast<double>(ranks.size());
    const auto distance = [mean](std::size_t of) { return std::abs(static_cast<double>(of) - mean); };
    constexpr double rounding = 1e-9;
    double all = 0, extreme = 0;
    for (std::size_t of = 0; of <= most; ++of) {
        all += choices[m][of];
        extreme += distance(of) > distance(sum) - rounding ? choices[m][of] : 0;
    }
    return extreme / all;
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
    const bool exact = first.size() + second.size() <= most_counted;
    const auto sum = static_cast<std::size_t>(std::llround(2 * ranks.sums[0]));
    return {.p = exact ? exact_p(first.size(), ranks.doubled, sum) : normal_p(ranks, pairs),
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
