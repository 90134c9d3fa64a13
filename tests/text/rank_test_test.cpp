#include "text/rank_test.hpp"

#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <utility>
#include <vector>

using namespace placedpar;

namespace {

doctest::Approx near(double published) { return doctest::Approx(published).epsilon(1e-9); }

/// Returns the p of two groups without equal figures, of which the first is greater in `pairs` pairs.
double p_of(std::size_t each, std::size_t pairs) {
    std::vector<double> first, second;
    for (std::size_t i = 0; i < each; ++i)
        second.push_back(static_cast<double>(i));
    for (std::size_t left = pairs, i = 0; i < each; ++i) { // a figure of the first group exceeds `above` of the second
        const std::size_t above = left < each ? left : each;
        left -= above;
        first.push_back(static_cast<double>(above) - 0.5 - 0.01 * static_cast<double>(i));
    }
    return mann_whitney(first, second).p;
}

} // namespace

TEST_CASE("the test of Mann and Whitney agrees with SciPy's documentation and R's examples") {
    const std::vector<double> males{19, 22, 16, 29, 24}, females{20, 11, 17, 12};
    const RankTest diagnosis = mann_whitney(males, females); // scipy.stats.mannwhitneyu: U = 17, p = 0.1111
    CHECK(diagnosis.exact);
    CHECK(diagnosis.p == near(0.1111111111111111));
    CHECK(diagnosis.effect == near(17.0 / 20));
    CHECK(mann_whitney(females, males).p == near(0.1111111111111111));
    CHECK(mann_whitney(females, males).effect == near(3.0 / 20));
    // R, wilcox.test: permeability of the amnion; W = 35, p = 0.1272 on one side
    const RankTest amnion =
        mann_whitney({0.80, 0.83, 1.89, 1.04, 1.45, 1.38, 1.91, 1.64, 0.73, 1.46}, {1.15, 0.88, 0.90, 0.74, 1.21});
    CHECK(amnion.effect == near(35.0 / 50));
    CHECK(amnion.p == doctest::Approx(2 * 0.1272).epsilon(4e-4));
}

TEST_CASE("equal figures are corrected for, as in R's wilcox.test: ozone in May and August, W = 127.5, p = 0.0001208") {
    const RankTest ozone = mann_whitney(
        {41, 36, 12, 18, 28, 23, 19, 8, 7, 16, 11, 14, 18, 14, 34, 6, 30, 11, 1, 11, 4, 32, 23, 45, 115, 37},
        {39, 9, 16, 78, 35, 66, 122, 89, 110, 44, 28, 65, 22, 59, 23, 31, 44, 21, 9, 45, 168, 73, 76, 118, 84, 85});
    CHECK_FALSE(ozone.exact);
    CHECK(ozone.effect == near(127.5 / (26 * 26)));
    CHECK(ozone.p == doctest::Approx(0.0001208).epsilon(4e-4));
}

TEST_CASE(
    "with equal figures, p is the share of all choices of the first group whose ranks are at least as far apart") {
    for (unsigned world = 0; world < 4096;
         ++world) { // six figures from 0 to 3, of which the first two or three are a group
        std::vector<double> figures;
        for (unsigned i = 0; i < 6; ++i)
            figures.push_back(world >> 2 * i & 3);
        const unsigned size = 2 + world % 2;
        const auto far = [&figures](unsigned chosen) { // twice the distance of the chosen figures' wins from the mean
            int wins = 0;
            for (unsigned i = 0; i < 6; ++i)
                for (unsigned j = 0; j < 6; ++j)
                    if ((chosen >> i & 1) != 0 && (chosen >> j & 1) == 0)
                        wins += (figures[i] > figures[j]) - (figures[i] < figures[j]);
            return std::abs(wins);
        };
        double all = 0, extreme = 0;
        for (unsigned chosen = 0; chosen < 64; ++chosen)
            if (static_cast<unsigned>(std::popcount(chosen)) == size) {
                ++all;
                extreme += far(chosen) >= far((1U << size) - 1);
            }
        const RankTest test =
            mann_whitney({figures.begin(), figures.begin() + size}, {figures.begin() + size, figures.end()});
        CHECK(test.exact);
        CHECK(test.p == near(extreme / all));
    }
}

TEST_CASE("the printed tables of U at 5 % on two sides are met: 2, 23 and 127 for groups of 5, 10 and 20") {
    for (const auto& [each, critical] : std::vector<std::pair<std::size_t, std::size_t>>{{5, 2}, {10, 23}, {20, 127}}) {
        CHECK(p_of(each, critical) <= 0.05);
        CHECK(p_of(each, critical + 1) > 0.05);
    }
}

TEST_CASE("the test of Kruskal and Wallis agrees with SciPy's documentation and R's examples") {
    CHECK(kruskal_wallis({{1, 3, 5, 7, 9}, {2, 4, 6, 8, 10}}).p == near(0.6015081344405895)); // H = 0.27272727
    const RankTest tied = kruskal_wallis({{1, 1, 1}, {2, 2, 2}, {2, 2}});                     // H = 7
    CHECK(tied.p == near(0.0301973834223185));
    CHECK(tied.effect == near(7.0 / 7));
    // R, kruskal.test: mucociliary efficiency; H = 0.77143, p = 0.68
    const RankTest dust = kruskal_wallis({{2.9, 3.0, 2.5, 2.6, 3.2}, {3.8, 2.7, 4.0, 2.4}, {2.8, 3.4, 3.7, 2.2, 2.0}});
    CHECK(dust.effect == doctest::Approx(0.77143 / 13).epsilon(1e-5));
    CHECK(dust.p == doctest::Approx(0.68).epsilon(1e-2));
}

TEST_CASE("figures that are all equal show no difference") {
    const RankTest two = mann_whitney({3, 3}, {3, 3, 3}), three = kruskal_wallis({{3, 3}, {3}, {3, 3}});
    CHECK((two.p == 1 && two.effect == 0.5));
    CHECK((three.p == 1 && three.effect == 0));
}
