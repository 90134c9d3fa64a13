// Tests scaling, ranking and tournaments. Roulette and universal sampling have their own files.

#include "gaprocs/policies/reproduction.hpp"
#include "runtime/random.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <vector>

using namespace placedpar;

namespace {

/// Returns each individual's mean number of copies over `times` choices. Each choice has as many parents as there are
/// individuals.
std::vector<double> mean_copies(const Reproduction& reproduce, const std::vector<double>& fitness, int times) {
    RandomStream random(1, "copies");
    std::vector<double> copies(fitness.size());
    for (int i = 0; i < times; ++i) {
        auto parents = reproduce(fitness, fitness.size(), random);
        for (std::size_t parent : parents.value())
            copies.at(parent) += 1.0 / times;
    }
    return copies;
}

void check_copies(const Reproduction& reproduce, const std::vector<double>& fitness,
                  const std::vector<double>& expected) {
    CAPTURE(reproduce.text());
    auto copies = mean_copies(reproduce, fitness, 20000);
    for (std::size_t i = 0; i < expected.size(); ++i) {
        CAPTURE(i);
        CHECK(std::abs(copies[i] - expected[i]) < 0.05); // five standard deviations of a binomial with variance 2
    }
}

const std::vector<double> five{-3, 10, 2, 1, 0}; // mean 2

} // namespace

TEST_CASE("linear ranking makes `best` copies of the best and 2 - `best` of the worst") {
    check_copies(RankingReproduction{2}, five, {0, 2, 1.5, 1, 0.5});
    check_copies(RankingReproduction{1.2}, five, {0.8, 1.2, 1.1, 1, 0.9});
    check_copies(RankingReproduction{1}, five, {1, 1, 1, 1, 1});
    check_copies(RankingReproduction{2}, {7, 7, 1, 9}, {1, 1, 0, 2}); // equals share their ranks
    check_copies(RankingReproduction{2}, {5}, {1});
}

TEST_CASE(
    "linear scaling makes one copy at the mean and `best` of the best, unless the worst would have fewer than 0") {
    check_copies(ScaledReproduction{1.4}, five, {1 - 0.05 * 5, 1.4, 1, 0.95, 0.9}); // slope .4 / 8
    check_copies(ScaledReproduction{100}, five, {0, 1 + 8. / 5, 1, 0.8, 0.6});      // slope 1 / 5: the worst has 0
                                                                                    // copies
    check_copies(ScaledReproduction{2}, {4, 4, 4}, {1, 1, 1});
    constexpr double most = std::numeric_limits<double>::max();
    check_copies(ScaledReproduction{2}, {-most, most, 0}, {0, 2, 1});
}

TEST_CASE("the best of n individuals wins a tournament of k with probability 1 - (1 - 1/n)^k") {
    check_copies(TournamentReproduction{1}, five, {1, 1, 1, 1, 1});
    // An individual wins if no candidate is better, and not all candidates are worse.
    auto expected = [](double k) {
        std::vector<double> copies;
        for (double worse : {0., 4., 3., 2., 1.}) // number of worse individuals, for each of the five
            copies.push_back(5 * (std::pow((worse + 1) / 5, k) - std::pow(worse / 5, k)));
        return copies;
    };
    check_copies(TournamentReproduction{2}, five, expected(2));
    check_copies(TournamentReproduction{7}, five, expected(7));
}

TEST_CASE("scaling, ranking and tournaments depend only on differences of fitness") {
    std::vector<double> shifted;
    for (double each : five)
        shifted.push_back(each - 1000);
    for (const char* way : {"scaled(1.5)", "ranking", "tournament(3)"}) {
        Reproduction reproduce = Reproduction::named(way);
        RandomStream a(5, "shift"), b(5, "shift");
        CHECK(reproduce(five, 50, a) == reproduce(shifted, 50, b));
    }
}

TEST_CASE("every reproduction can choose any number of parents, even or odd") {
    RandomStream random(5, "count");
    for (const PolicyDescription& way : Reproduction::descriptions())
        for (std::size_t count : {1u, 2u, 7u, 100u})
            CHECK(Reproduction::named(way.name)(std::vector<double>{1, 2, 3}, count, random)->size() == count);
}
