#include "gaprocs/policies/acceptance.hpp"
#include "runtime/random.hpp"
#include "tests/gaprocs/strings.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <set>

using namespace placedpar;
using test::strings;

namespace {

/// Five individuals. Number 3 is the best, number 1 the worst.
struct Home {
    std::vector<Genome> population = strings({"0000", "0011", "0111", "1111", "1100"});
    std::vector<double> fitness{3, -2, 5, 9, 4};

    Places places(const char* acceptance, const std::vector<Individual>& immigrants, std::size_t elite = 0,
                  std::uint64_t seed = 1) const {
        RandomStream random(seed, "places");
        return Acceptance::named(acceptance)({population, fitness, elite}, immigrants, random);
    }
};

Individual immigrant(const char* text, double fitness) { return {Genome::from_string(text), fitness}; }

const auto rejected = std::nullopt;

} // namespace

TEST_CASE("the worst is replaced, and immigrants of one exchange do not replace each other") {
    Home home;
    CHECK(home.places("worst", {immigrant("1010", -99)}) == Places{1});
    CHECK(home.places("worst", {immigrant("1010", -99), immigrant("1011", 0), immigrant("1000", 7)}) ==
          Places{1, 0, 4});
    CHECK(home.places("worst", {}).empty());
    home.fitness = {2, 1, 1, 3, 1};
    CHECK(home.places("worst", {immigrant("1010", 0), immigrant("1010", 0)}) == Places{1, 2}); // the first among equals
}

TEST_CASE(
    "with only_if_better, an immigrant that is not fitter is rejected, and the next may replace the same individual") {
    Home home;
    CHECK(home.places("worst(1)", {immigrant("1010", -2)}) == Places{rejected});
    CHECK(home.places("worst(only_if_better = 1)", {immigrant("1010", -3), immigrant("1010", 1)}) ==
          Places{rejected, 1});
    CHECK(home.places("alike(1)", {immigrant("1110", 4), immigrant("1000", 4)}) == Places{rejected, 0});
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        CHECK(home.places("random(1)", {immigrant("1010", -2)}, 0, seed) == Places{rejected});
        CHECK(home.places("random(1)", {immigrant("1010", 10)}, 0, seed).front().has_value());
    }
}

TEST_CASE("the most similar individual is replaced; among equals the least fit") {
    Home home;
    CHECK(home.places("alike", {immigrant("0111", 0)}) == Places{2});
    CHECK(home.places("alike", {immigrant("1000", 0)}) == Places{0}); // 0000 and 1100 both differ from 1000 in one bit;
                                                                      // 0000 is less fit
    CHECK(home.places("alike", {immigrant("1000", 0), immigrant("1000", 0)}) == Places{0, 4});
    CHECK(home.places("alike", {immigrant("1111", 0)}) == Places{3});
    CHECK(home.places("alike", {immigrant("1111", 0)}, 1) == Places{2}); // individual 3 belongs to the elite
}

TEST_CASE("random acceptance replaces each individual outside the elite with the same probability") {
    Home home;
    constexpr int times = 20000;
    std::vector<double> chance(5);
    RandomStream random(1, "chances");
    std::vector<Individual> one{immigrant("1010", 0)};
    for (int i = 0; i < times; ++i)
        chance.at(RandomAcceptance{}({home.population, home.fitness, 2}, one, random).front().value()) += 1.0 / times;
    const std::vector<double> expected{1 / 3., 1 / 3., 0, 0, 1 / 3.};
    for (std::size_t i = 0; i < 5; ++i)
        CHECK(std::abs(chance[i] - expected[i]) < 0.017); // five standard deviations
}

TEST_CASE("acceptance among the offspring replaces each individual outside the elite with the same probability") {
    Home home;
    constexpr int times = 20000;
    std::vector<double> chance(5);
    RandomStream random(1, "chances");
    std::vector<Individual> one{immigrant("1010", -99)};
    for (int i = 0; i < times; ++i)
        chance.at(Acceptance(OffspringAcceptance{})({home.population, {}, 2}, one, random).front().value()) +=
            1.0 / times;
    const std::vector<double> expected{0, 0, 1 / 3., 1 / 3., 1 / 3.};
    for (std::size_t i = 0; i < 5; ++i)
        CHECK(std::abs(chance[i] - expected[i]) < 0.017); // five standard deviations
}

TEST_CASE("the elite is never replaced, and no place is given twice") {
    Home home;
    std::vector<Individual> three(3, immigrant("1111", 1));
    for (const PolicyDescription& way : Acceptance::descriptions())
        for (std::uint64_t seed = 1; seed <= 200; ++seed) {
            std::set<std::size_t> taken;
            for (auto place : home.places(way.name.c_str(), three, 2, seed))
                taken.insert(place.value());
            bool bred = Acceptance::named(way.name).among_offspring(); // the elite of a bred population comes first
            CHECK(taken == (bred ? std::set<std::size_t>{2, 3, 4} : std::set<std::size_t>{0, 1, 4}));
        }
}

TEST_CASE("among individuals of equal fitness, those of higher index are the elite") {
    Home home;
    home.fitness.assign(5, 1);
    for (const char* way : {"worst", "random", "alike"}) {
        auto places = home.places(way, {immigrant("1111", 0), immigrant("1111", 0)}, 3);
        CHECK(std::set(places.begin(), places.end()) == std::set<Places::value_type>{0, 1});
    }
}

TEST_CASE("more immigrants than individuals outside the elite are refused") {
    Home home;
    std::vector<Individual> four(4, immigrant("1111", 1)), six(6, immigrant("1111", 1));
    for (const PolicyDescription& way : Acceptance::descriptions()) {
        CHECK_THROWS_WITH_AS(
            home.places(way.name.c_str(), four, 2),
            "4 immigrants come in one exchange to an island of 5 individuals with an elite of 2; expected at most 3",
            UserError);
        CHECK_THROWS_AS(home.places(way.name.c_str(), six), UserError);
        CHECK(home.places(way.name.c_str(), four, 1).size() == 4);
    }
}

TEST_CASE("the refusal of one immigrant to one individual has singular nouns") {
    CHECK_THROWS_WITH_AS(
        Acceptance::validate_for(1, 1, 1),
        "1 immigrant comes in one exchange to an island of 1 individual with an elite of 1; expected at most 0",
        UserError);
}

TEST_CASE("acceptances are named by their text") {
    CHECK(Acceptance().text() == "worst(only_if_better = 0)");
    CHECK(Acceptance::named("alike(1)").text() == "alike(only_if_better = 1)");
    CHECK_THROWS_WITH_AS(Acceptance::named("worst(2)"),
                         "only_if_better = 2 is out of range: only_if_better is a whole number from 0 to 1", UserError);
}
