// Tests with few seeds and loose bounds. For all seeds: placedpar replay pga-1 to pga-5.

#include "experiments/chapter_5/kit/plant_islands.hpp"

#include "experiments/chapter_5/kit/tracking.hpp"
#include "text/statistics.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace placedpar;

namespace {

double median_of(const PlantIslands& islands, Tracking figure, std::uint64_t seeds = 8) {
    std::vector<double> values;
    for (std::uint64_t seed = 0; seed < seeds; ++seed)
        values.push_back(
            track(search_plant(islands, seed).islands.front(), islands.plant.change)[static_cast<std::size_t>(figure)]);
    return median(values);
}

PlantIslands one_island(std::size_t population, std::size_t window, std::size_t per_sample = 3) {
    PlantIslands islands{};
    islands.populations = {population};
    islands.windows = {window};
    islands.plant.per_sample = per_sample;
    return islands;
}

} // namespace

TEST_CASE("a long window follows the change later than a short one, with three generations a sample") {
    CHECK(median_of(one_island(100, 30), Tracking::delay_20) == doctest::Approx(114).epsilon(0.25));
    CHECK(median_of(one_island(100, 10), Tracking::delay_20) == doctest::Approx(68).epsilon(0.3));
    CHECK(median_of(one_island(100, 30, 1), Tracking::delay_20) /
              median_of(one_island(100, 10, 1), Tracking::delay_20) <
          1.6);
}

TEST_CASE("a genetic algorithm of 100 finds the pole before the change, and lags behind it") {
    CHECK(median_of(one_island(100, 30), Tracking::error_before) < 0.05);
    CHECK(median_of(one_island(100, 30), Tracking::lag) == doctest::Approx(86).epsilon(0.25));
}

TEST_CASE("with ranking, Gray code follows a change that natural binary code misses") {
    PlantIslands islands = one_island(100, 30);
    islands.reproduction = "ranking(best = 2)";
    CHECK(median_of(islands, Tracking::error_after) > 0.1);
    islands.coding = Coding::gray;
    CHECK(median_of(islands, Tracking::error_after) < 0.05);
}

TEST_CASE("the same seed gives the same run, and answers change nothing on the islands") {
    PlantIslands islands{};
    islands.populations = distributed_populations;
    islands.windows = distributed_windows;
    islands.topology = "complete";
    PlantSearchRun silent = search_plant(islands, 5);
    islands.choices = {"printed", "row", "random", "fixed(island = 3)"};
    PlantSearchRun run = search_plant(islands, 5), again = search_plant(islands, 5);
    CHECK(run.chosen == again.chosen);
    CHECK(run.diversity == silent.diversity);
    for (std::size_t island = 0; island < 4; ++island)
        for (std::size_t generation = 0; generation < 601; ++generation)
            CHECK(run.islands[island][generation].alpha == silent.islands[island][generation].alpha);
    CHECK(run.chosen[0].size() == 50);
    for (std::size_t choice : run.chosen[0])
        CHECK(choice != 3);
    CHECK(run.answers[3][598].alpha == run.islands[3][587].alpha);
    CHECK(run.answers[3][11].alpha == run.islands[3][11].alpha);
}
