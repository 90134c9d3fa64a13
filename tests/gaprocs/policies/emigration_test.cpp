#include "gaprocs/policies/emigration.hpp"
#include "runtime/random.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <set>
#include <vector>

using namespace placedpar;

namespace {

using Indices = std::vector<std::size_t>;

const std::vector<double> five_fitnesses{-3, 10, 2, 1, 0};
constexpr int choices = 20000;

/// Returns the fraction of many choices in which each individual is chosen.
std::vector<double> chances(const Emigration& emigration, const std::vector<double>& fitness) {
    RandomStream random(1, "emigration");
    std::vector<double> chance(fitness.size());
    for (int i = 0; i < choices; ++i)
        for (std::size_t index : emigration(fitness, random))
            chance.at(index) += 1.0 / choices;
    return chance;
}

void check_chances(const char* emigration, const std::vector<double>& expected) {
    CAPTURE(emigration);
    auto chance = chances(Emigration::named(emigration), five_fitnesses);
    for (std::size_t i = 0; i < expected.size(); ++i)
        CHECK(std::abs(chance[i] - expected[i]) < 0.018); // at most five standard deviations
}

/// Returns the stream's next number. Draws it from a copy, so the caller's stream does not advance.
std::uint32_t next_number(RandomStream random) { return random(); }

} // namespace

TEST_CASE("the best leave first, among equals the lowest index first, without a draw") {
    RandomStream random(1, "best");
    auto before = next_number(random);
    CHECK(Emigration()(five_fitnesses, random) == Indices{1});
    CHECK(Emigration::named("best(3)")(five_fitnesses, random) == Indices{1, 2, 3});
    CHECK(Emigration::named("best(5)")(five_fitnesses, random) == Indices{1, 2, 3, 4, 0});
    CHECK(Emigration::named("best(2)")(std::vector<double>{4, 7, 4, 7}, random) == Indices{1, 3});
    CHECK(next_number(random) == before);
}

TEST_CASE("in random emigration each individual leaves with probability count / n") {
    check_chances("random(1)", {0.2, 0.2, 0.2, 0.2, 0.2});
    check_chances("random(3)", {0.6, 0.6, 0.6, 0.6, 0.6});
    check_chances("random(5)", {1, 1, 1, 1, 1});
}

TEST_CASE("in a tournament of k, rank r of n leaves with probability ((n - r + 1)/n)^k - ((n - r)/n)^k") {
    check_chances("tournament(1, 1)", {0.2, 0.2, 0.2, 0.2, 0.2});
    check_chances("tournament(count = 1, size = 2)", {1 / 25., 9 / 25., 7 / 25., 5 / 25., 3 / 25.});
    check_chances("tournament(1, 3)", {1 / 125., 61 / 125., 37 / 125., 19 / 125., 7 / 125.});
    check_chances("tournament(5)", {1, 1, 1, 1, 1});
}

TEST_CASE("the second of two tournaments is among the individuals that are left") {
    // The better of two individuals wins the first tournament with probability 3/4; the other wins the second.
    const std::vector<double> two{1, 2};
    RandomStream random(3, "two");
    int better_first = 0;
    for (int i = 0; i < choices; ++i) {
        auto chosen = Emigration::named("tournament(2)")(two, random);
        CHECK(std::set<std::size_t>(chosen.begin(), chosen.end()).size() == 2);
        better_first += chosen.front() == 1;
    }
    CHECK(std::abs(better_first / double(choices) - 0.75) < 0.018);
}

TEST_CASE("the same stream gives the same emigrants") {
    for (const char* emigration : {"random(2)", "tournament(2, 3)"}) {
        RandomStream a(9, "same"), b(9, "same");
        for (int i = 0; i < 10; ++i)
            CHECK(Emigration::named(emigration)(five_fitnesses, a) == Emigration::named(emigration)(five_fitnesses, b));
    }
}

TEST_CASE("more emigrants than individuals are refused") {
    RandomStream random(1, "many");
    for (const char* emigration : {"best(6)", "random(6)", "tournament(6)"})
        CHECK_THROWS_WITH_AS(Emigration::named(emigration)(five_fitnesses, random),
                             "6 emigrants cannot leave a population of 5, expected at most 5", UserError);
    CHECK_THROWS_WITH_AS(Emigration::named("best(0)"),
                         "count = 0 is out of range: count is a whole number from 1 to 1000000", UserError);
    CHECK(Emigration().text() == "best(count = 1)");
}
