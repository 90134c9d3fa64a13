// Tests studies of the changing plant: their figures and texts, and the configurations of Table 5.3.

#include "experiments/chapter_5/kit/plant_study.hpp"

#include "tests/experiments/kit/replay_in_memory.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

using namespace placedpar;

namespace {

/// Returns the ramp's true pole, delayed by `late` generations.
std::vector<Pole> pole_late_by(int late) {
    std::vector<Pole> found;
    for (int generation = 0; generation <= 600; ++generation)
        found.push_back(pole_of(a1_at(PlantChange::ramp, generation - late), Plant().a2));
    return found;
}

/// A study whose n-th seed follows the pole with a delay of 10 n generations.
PlantStudy late_study(const ReplayContext& context) {
    const Seeds seeds = seeds_of(context);
    return study_pole(context, "late", {}, [&](std::uint64_t seed) {
        return pole_late_by(10 * static_cast<int>(std::ranges::find(seeds, seed) - seeds.begin()));
    });
}

/// Returns how many evaluations of the error one generation of all islands takes.
std::size_t errors_a_generation(const PlantIslands& islands) {
    return std::inner_product(islands.populations.begin(), islands.populations.end(), islands.windows.begin(),
                              std::size_t{0});
}

} // namespace

TEST_CASE("a study of a pole keeps the figures of each seed in order, and every fifth pole") {
    test::ReplayInMemory replay(3);
    const PlantStudy study = late_study(replay.context);
    CHECK(study.lags() == std::vector<double>{0, 10, 20});
    CHECK(study.of(0, Tracking::delay_20) == std::vector<double>{40, 50, 60});
    CHECK(study.median(0, Tracking::lag) == 10);
    CHECK(study.found_percent(0) == 100); // all have found it when the ramp ends
    REQUIRE(study.runs.at(2).at(0).poles.size() == 121);
    CHECK(study.runs[2][0].poles[60].alpha == pole_late_by(20)[300].alpha);
    CHECK_THROWS_WITH_AS(study.answer("fittest"), "late has no answer by fittest", std::invalid_argument);
}

TEST_CASE("runs with different noise have different names in a study") {
    test::ReplayInMemory replay(1);
    PlantExperiment coloured;
    coloured.noise = 0.3;
    coloured.colour = {0.5, 0.25};
    for (const PlantExperiment& plant : {PlantExperiment(), coloured})
        study_pole(replay.context, "late", plant, [](std::uint64_t) { return pole_late_by(0); });
    CHECK(replay.results.count() == 2);
    CHECK(replay.told.front() == "late, noiseless: 0 of 1 seeds");
    CHECK(std::ranges::count(replay.told, "late, sigma = 0.3, c1 = 0.5, c2 = 0.25: 0 of 1 seeds") == 1);
}

TEST_CASE("the answer of an island choice is a track after those of the islands") {
    PlantStudy study;
    study.islands = traditional_pga("broadcast(every = 12)", 0);
    study.islands.choices = {"fittest", "random"};
    CHECK(study.answer("fittest") == 4);
    CHECK(answer_row(study, "random").track == 5);
    CHECK(answer_row(study, "random").name == "random");
}

TEST_CASE("figures of the same seeds are compared one by one; a quotient of nothing by nothing is 1") {
    CHECK(less({5, 7}, {3, 10}) == std::vector<double>{2, -3});
    const std::vector<double> by = ratio({2, 0, 1}, {1, 0, 0});
    CHECK(by[0] == doctest::Approx(2).epsilon(1e-3));
    CHECK(by[1] == 1);
    CHECK(by[2] == doctest::Approx(1001)); // not infinite
}

TEST_CASE("the configurations of Table 5.3 have equal numbers of individuals, and the search of equal cost equal "
          "evaluations") {
    const PlantIslands distributed = distributed_pga("sequential(every = 3)", 0.3);
    CHECK(errors_a_generation(distributed) == 2580);
    CHECK(errors_a_generation(equal_cost_ga(0.3)) == errors_a_generation(distributed));
    CHECK(distributed.topology == "hypercube");
    CHECK(distributed.plant.noise == 0.3);
    CHECK(traditional_pga("broadcast(every = 12)", 0).topology == "complete");
    CHECK(single_ga(0).populations == std::vector<std::size_t>{100});
    const PlantIslands simulated = simulated_in_window(single_ga(0));
    CHECK(simulated.plant.per_sample == 5);
    CHECK(simulated.bias == 100);
    CHECK(simulated.name == "GA of 100, window 30, simulated");
    CHECK(noise_name(0) == "noiseless");
    CHECK(noise_name(0.3) == "sigma = 0.3");
}

TEST_CASE("a row of a table of tracks has medians over the seeds and the share that found the pole") {
    test::ReplayInMemory replay(3);
    const PlantStudy study = late_study(replay.context);
    const Comparison table = tracks_comparison("tracks", {{"late", &study}});
    REQUIRE(table.cells.size() == 6);
    CHECK(table.cells[0].column == "delay to 20 %");
    CHECK(table.cells[0].simulated == 50);
    CHECK(table.cells[1].simulated == 10);
    CHECK(table.cells[5].column == "found [%]");
    CHECK(table.cells[5].simulated == 100);
    CHECK(judged_delay({"late", &study}, 52, 2).within_tolerance());
    CHECK_FALSE(judged_delay({"late", &study}, 53, 2).within_tolerance());
    CHECK(median_of_seeds(replay.context) == "medians of 3 seeds, quartiles of the real part");
}

TEST_CASE(
    "a plot of poles has real and imaginary parts over the generations beside the truth, and a band of quartiles") {
    test::ReplayInMemory replay(3);
    const PlantStudy study = late_study(replay.context);
    const Panel medians = pole_panel("poles", {{"late", &study}}),
                first = single_run_panel("poles", {{"late", &study}});
    REQUIRE(medians.series.size() == 4);
    CHECK(medians.series[0].name == "late");
    CHECK(medians.series[1].stroke == Stroke::dashes);
    CHECK(medians.series[0].points.at(60).x == 300);
    CHECK(medians.series[0].points[60].y == pole_late_by(10)[300].alpha); // the median of the three
    CHECK(medians.series[1].points[60].y == pole_late_by(10)[300].beta);
    CHECK(medians.series[2].name == "truth");
    CHECK(medians.series[2].points.front().y == 0.75);
    CHECK(medians.series[2].points.back().y == 0.25);
    CHECK(medians.series[3].points.front().y == doctest::Approx(0.370810)); // square root of .7 - .75^2
    REQUIRE(medians.bands.size() == 1);
    CHECK(medians.bands[0].points.at(60).low == pole_late_by(0)[300].alpha);
    CHECK(medians.bands[0].points[60].high == pole_late_by(20)[300].alpha);
    CHECK(first.series[0].points.at(60).y == pole_late_by(0)[300].alpha);
}
