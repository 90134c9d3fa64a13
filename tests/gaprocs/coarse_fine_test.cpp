#include "gaprocs/coarse_fine.hpp"
#include "gaprocs/spread_population.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <set>
#include <span>
#include <stdexcept>

using namespace placedpar;

namespace {

/// A problem of two numbers of 8 bits. The optimum is at 200 and 77.
struct TwoNumbers {
    std::size_t bits() const { return 16; }
    std::size_t channels() const { return 1; }
    template <class G>
    double error(const G& genome, std::span<const double>) const {
        auto off = [&](std::size_t first, double wanted) {
            return static_cast<double>(genome.field(first, 8)) - wanted;
        };
        return std::abs(off(0, 200)) + std::abs(off(8, 77));
    }
    template <class G>
    std::vector<double> decode(const G& genome) const {
        return {static_cast<double>(genome.field(0, 8)), static_cast<double>(genome.field(8, 8))};
    }
    std::vector<std::string> parameter_names() const { return {"a", "b"}; }
    std::vector<std::string> parameter_units() const { return {"", ""}; }
};

CoarseFineSettings pair_settings() {
    SearchSettings each;
    each.population = 30;
    each.elite = 1;
    each.window = {.length = 1, .first = 1, .trials = 1, .bias = 1e5};
    return {each, each, {.problem_bits = {8, 8}, .bits = {4, 4}}, {5, 5}};
}

} // namespace

TEST_CASE(
    "the coarse search finds the cell of the optimum, the fine search the optimum, and the same seed gives the same") {
    auto problem = make_search_problem(TwoNumbers());
    CoarseFine pair(*problem, pair_settings(), 3), again(*problem, pair_settings(), 3);
    for (CoarseFine* each : {&pair, &again}) {
        each->push({0});
        REQUIRE(each->ready());
        for (int generation = 0; generation < 300; ++generation)
            each->next_generation();
    }
    auto coarse = problem->decode(pair.coarse_best().genome), fine = problem->decode(pair.fine_best().genome);
    for (double number : coarse)
        CHECK(static_cast<int>(number) % 16 == 0);
    CHECK(fine[0] == doctest::Approx(200).epsilon(0.02));
    CHECK(fine[1] == doctest::Approx(77).epsilon(0.03));
    CHECK(pair.fine_best().fitness > pair.coarse_best().fitness);
    CHECK(again.fine_best() == pair.fine_best());
}

TEST_CASE("a pair with different windows is refused, and so is a fine search with more bits than its problem") {
    auto problem = make_search_problem(TwoNumbers());
    CoarseFineSettings settings = pair_settings();
    settings.fine.window.bias = 1;
    CHECK_THROWS_AS(CoarseFine(*problem, settings, 1), std::invalid_argument);
    settings = pair_settings();
    settings.fine_bits = {9, 5};
    CHECK_THROWS_AS(CoarseFine(*problem, settings, 1), std::invalid_argument);
}

TEST_CASE("in a spread population the codes of a field are equally frequent, in every coding") {
    for (const char* coding : {"natural", "natural(1)", "gray", "gray(1)"}) {
        Recoding reading{.problem_bits = {3, 2}, .bits = {3, 2}, .coding = Coding::named(coding)};
        RandomStream random(5, "spread");
        auto population = spread_population(16, reading, random);
        std::multiset<std::uint64_t> first, second;
        for (const Genome& each : reading.to_problem(population)) {
            first.insert(each.field(0, 3));
            second.insert(each.field(3, 2));
        }
        for (std::uint64_t code = 0; code < 8; ++code)
            CHECK(first.count(code) == 2);
        for (std::uint64_t code = 0; code < 4; ++code)
            CHECK(second.count(code) == 4);
    }
}
