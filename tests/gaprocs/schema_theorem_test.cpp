#include "gaprocs/schema_theorem.hpp"
#include "gaprocs/search.hpp"
#include "tests/gaprocs/strings.hpp"
#include "tests/sanitized.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace placedpar;

namespace {

SearchSettings settings_with(double crossover_probability, double mutation_probability) {
    SearchSettings settings;
    settings.population = 6;
    settings.crossover_probability = crossover_probability;
    settings.mutation_probability = mutation_probability;
    return settings;
}

} // namespace

TEST_CASE("the bound of equation 6.2 has the values computed by hand") {
    auto population = test::strings({"1100", "1001", "0111", "0000"});
    std::vector<double> fitness{6, 2, 4, -3};
    // Strings of 1*** have 8 of the total fitness 12, so 4 * 8 / 12 copies on average. No cut can disrupt this schema.
    CHECK(schema_bound(Schema::from_string("1***"), population, fitness, 0.8, 0.01) ==
          doctest::Approx(4 * 8 / 12.0 * 0.99));
    // Strings of 1**1 have 2 of the total fitness 12. Every cut disrupts this schema.
    CHECK(schema_bound(Schema::from_string("1**1"), population, fitness, 0.8, 0.01) ==
          doctest::Approx(4 * 2 / 12.0 * (1 - 0.8) * 0.99 * 0.99));
    CHECK(schema_bound(Schema::from_string("0000"), population, fitness, 0.8, 0.01) == 0);
    CHECK(schema_bound(Schema::from_string("****"), population, fitness, 0.8, 0.01) == doctest::Approx(4));
    std::vector<double> none{0, -1, -2, -3};
    CHECK(schema_bound(Schema::from_string("1***"), population, none, 0.8, 0.01) == 0);
}

TEST_CASE(
    "on average at least as many strings as the bound match each schema, and by selection alone exactly as many") {
    auto population = test::strings({"1100", "1001", "0111", "0010", "1110", "0101"});
    std::vector<double> fitness{6, 2, 4, 1, 5, 3};
    constexpr int generations = test::sanitized ? 400 : 4000;
    for (std::size_t order : {1u, 2u})
        for (const Schema& schema : schemata_of_order(4, order)) {
            CAPTURE(schema.to_string());
            double sum = 0;
            for (int i = 0; i < generations; ++i) {
                Search search(population, settings_with(0.8, 0.01),
                              RandomStream(static_cast<std::uint64_t>(i), "schemata"));
                search.next_generation(fitness);
                sum += static_cast<double>(count_matches(schema, search.population()));
            }
            double mean = sum / generations, four_deviations = 4 * std::sqrt(6 / 4.0 / generations);
            CHECK(mean > schema_bound(schema, population, fitness, 0.8, 0.01) - four_deviations);
            // With selection alone, the bound equals the expected number.
            double by_selection = 0;
            for (int i = 0; i < generations; ++i) {
                Search search(population, settings_with(0, 0),
                              RandomStream(static_cast<std::uint64_t>(i), "selection"));
                search.next_generation(fitness);
                by_selection += static_cast<double>(count_matches(schema, search.population()));
            }
            CHECK(std::abs(by_selection / generations - schema_bound(schema, population, fitness, 0, 0)) <
                  four_deviations);
        }
}
