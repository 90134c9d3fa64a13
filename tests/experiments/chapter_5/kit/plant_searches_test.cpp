// Tests searches of the changing plant: their record, their islands, and studies of them over several seeds.

#include "experiments/chapter_5/kit/plant_study.hpp"

#include "problems/plant/plant_problem.hpp"
#include "tests/experiments/kit/replay_in_memory.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

using namespace placedpar;

namespace {

/// Returns small islands, which take milliseconds to run.
PlantIslands small_islands(std::size_t islands, const char* topology = "none") {
    PlantIslands plant = sized({}, "small", std::vector<std::size_t>(islands, 6), std::vector<std::size_t>(islands, 5));
    plant.topology = topology;
    return plant;
}

/// Returns y(k) - y-hat(k) of equation 5.8 for this a1, where the other coefficients are those of the plant.
double error_of_equation(const Sample& sample, double a1) {
    return sample[0] - (a1 * sample[1] - 0.7 * sample[2] + sample[3] + 0.5 * sample[4]);
}

bool same_poles(const std::vector<Pole>& one, const std::vector<Pole>& other) {
    return std::ranges::equal(one, other, [](Pole a, Pole b) { return a.alpha == b.alpha && a.beta == b.beta; });
}

} // namespace

TEST_CASE("the record obeys equation 5.8: with a1 = 1.5 before the change, and with a1 = .5 after it") {
    const auto samples = plant_samples({}, 1);
    CHECK(samples.size() == 29 + 201); // 601 generations, three for each sample
    for (std::size_t i = 0; i < 29 + 66; ++i)
        CHECK(std::abs(error_of_equation(samples[i], 1.5)) < 1e-12);
    for (std::size_t i = 29 + 134; i < samples.size(); ++i)
        CHECK(std::abs(error_of_equation(samples[i], 0.5)) < 1e-12);
    CHECK(std::abs(error_of_equation(samples[29 + 100], 1.0)) < 1e-12); // generation 300, in the middle of the ramp
}

TEST_CASE("all methods get the same record of a seed, and other seeds other records") {
    const PlantExperiment noisy{.noise = 0.3};
    CHECK(plant_samples(noisy, 7) == plant_samples(noisy, 7));
    CHECK(plant_samples(noisy, 7) != plant_samples(noisy, 8));
    const auto clean = plant_samples({}, 7), disturbed = plant_samples(noisy, 7);
    REQUIRE(clean.size() == disturbed.size());
    std::set<double> inputs;
    for (std::size_t i = 0; i < clean.size(); ++i) {
        inputs.insert(clean[i][3]);
        CHECK(clean[i][3] == disturbed[i][3]); // noise leaves the input as it is
    }
    CHECK(inputs == std::set<double>{-1, 1});
    CHECK(clean.back()[0] != disturbed.back()[0]);
}

TEST_CASE("white noise has the deviation that is asked for, by the errors of the true plant") {
    PlantExperiment noisy{.change = PlantChange::none, .noise = 0.3, .generations = 30000};
    double squares = 0, count = 0;
    for (const Sample& sample : plant_samples(noisy, 3)) {
        squares += error_of_equation(sample, 1.5) * error_of_equation(sample, 1.5);
        ++count;
    }
    CHECK(std::sqrt(squares / count) == doctest::Approx(0.3).epsilon(0.02)); // of 10,000 samples: 0.7 %
}

TEST_CASE("each island has a pole in each generation, a pair inside the unit square") {
    const PlantSearchRun run = search_plant(small_islands(3), 1);
    REQUIRE(run.islands.size() == 3);
    CHECK(run.answers.empty());
    for (const std::vector<Pole>& island : run.islands) {
        REQUIRE(island.size() == 601);
        for (const Pole& pole : island) {
            CHECK(std::abs(pole.alpha) <= 1);
            CHECK(pole.beta >= 0);
            CHECK(pole.beta <= 1);
        }
    }
}

TEST_CASE("islands that do not exchange are searches of their own: their answers differ") {
    const PlantSearchRun alone = search_plant(small_islands(2), 1), joined = search_plant(small_islands(2, "ring"), 1);
    CHECK_FALSE(same_poles(alone.islands[0], alone.islands[1]));
    CHECK_FALSE(same_poles(alone.islands[0], joined.islands[0])); // from the first exchange on
    for (std::size_t generation = 0; generation < 12; ++generation)
        CHECK(alone.islands[0][generation].alpha == joined.islands[0][generation].alpha);
}

TEST_CASE("a single island is its own first and last, and its diversity is between none and half of the 37 bits") {
    const PlantSearchRun run = search_plant(small_islands(1), 1);
    CHECK(run.identical == 1);
    CHECK(run.diversity > 0);
    CHECK(run.diversity < 18.5);
    PlantIslands large = small_islands(1);
    large.populations = {60};
    CHECK(search_plant(large, 1).diversity > 0);
}

TEST_CASE("the answer of a fixed island is that of the last broadcast; before it, the first island answers") {
    PlantIslands islands = small_islands(2, "complete");
    islands.choices = {"fixed(island = 1)"};
    const PlantSearchRun run = search_plant(islands, 4);
    REQUIRE(run.answers.size() == 1);
    REQUIRE(run.answers[0].size() == 601);
    for (std::size_t generation = 0; generation < 11; ++generation)
        CHECK(run.answers[0][generation].alpha == run.islands[0][generation].alpha);
    CHECK(std::ranges::all_of(run.chosen.at(0), [](std::size_t island) { return island == 1; }));
    CHECK(run.chosen[0].size() == 600 / 12);
}

TEST_CASE("a study has the figures of each seed's own search, in the order of the seeds") {
    test::ReplayInMemory replay(3);
    PlantIslands islands = small_islands(2, "complete");
    islands.choices = {"random"};
    const PlantStudy study = study_plant(replay.context, islands);
    const Seeds seeds = seeds_of(replay.context);
    REQUIRE(study.runs.size() == 3);
    for (std::size_t i = 0; i < 3; ++i) {
        const PlantSearchRun run = search_plant(islands, seeds[i]);
        CHECK(study.diversity[i] == run.diversity);
        CHECK(study.identical[i] == run.identical);
        REQUIRE(study.runs[i].size() == 3); // two islands and one answer
        CHECK(study.runs[i][1].figures == track(run.islands[1], islands.plant.change));
        CHECK(study.runs[i][2].figures == track(run.answers[0], islands.plant.change));
        CHECK(study.runs[i][2].poles.at(20).alpha == run.answers[0][100].alpha);
    }
    CHECK(study.errors_after() == study.of(0, Tracking::error_after));
    CHECK(replay.told.front() == "small, noiseless, answers by random: 0 of 3 seeds");
}

TEST_CASE("the share of searches that found the pole includes the limit of .1") {
    PlantStudy study;
    for (double error : {0.05, 0.1, 0.1001, 3.0}) {
        PlantTrack track{};
        track.figures[static_cast<std::size_t>(Tracking::error_after)] = error;
        study.runs.push_back({track});
    }
    CHECK(study.found_percent(0) == 50);
    CHECK(study.median(0, Tracking::error_after) == doctest::Approx(0.10005));
}

TEST_CASE("a row for each study has the name of its islands") {
    std::vector<PlantStudy> studies(2);
    studies[0].islands.name = "25 individuals";
    studies[1].islands.name = "50 individuals";
    const std::vector<TrackRow> rows = study_rows(studies);
    REQUIRE(rows.size() == 2);
    CHECK(rows[1].name == "50 individuals");
    CHECK(rows[1].study == &studies[1]);
    CHECK(rows[1].track == 0);
    CHECK(study_rows({}).empty());
}
