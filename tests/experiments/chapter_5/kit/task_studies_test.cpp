// Tests studies of functions that do not change: the generations to a target, and their tables and curves.

#include "experiments/chapter_5/kit/maximisation.hpp"

#include "experiments/kit/seed_runs.hpp"
#include "tests/experiments/kit/replay_in_memory.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

using namespace placedpar;

namespace {

const StaticTask ones{"one-max(bits = 20)", 20};

/// A study of one size in which some of four runs reached the target.
TaskStudy study_of_four(std::vector<double> taken) {
    return {.task = {"foxholes", 1}, .sizes = {96}, .limit = 500, .taken = {std::move(taken)}};
}

} // namespace

TEST_CASE("a study of a task has the generations of each seed, in the order of the seeds") {
    test::ReplayInMemory replay(4);
    const std::vector<double> taken = study_task(replay.context, ones, 2, 10, 60);
    const Seeds seeds = seeds_of(replay.context);
    REQUIRE(taken.size() == 4);
    for (std::size_t i = 0; i < 4; ++i)
        CHECK(taken[i] == static_cast<double>(generations_to_target(ones, 2, 10, 60, seeds[i])));
    CHECK(replay.told.front() == "one-max(bits = 20), 2 islands of 10, 60 generations: 0 of 4 seeds");
}

TEST_CASE("studies of another size or limit are runs of their own, and equal ones are not repeated") {
    test::ReplayInMemory replay(2);
    study_task(replay.context, ones, 2, 10, 30);
    study_task(replay.context, ones, 2, 10, 40);
    study_task(replay.context, ones, 4, 5, 40);
    CHECK(replay.results.count() == 6);
    study_task(replay.context, ones, 4, 5, 40);
    CHECK(replay.results.count() == 6);
}

TEST_CASE("the best so far never falls, and reaches the target in the generation that is counted") {
    test::ReplayInMemory replay(3);
    const ConvergenceCurve curve = study_convergence(replay.context, ones, 2, 10, 60);
    const Seeds seeds = seeds_of(replay.context);
    REQUIRE(curve.runs.size() == 3);
    for (std::size_t i = 0; i < 3; ++i) {
        const std::vector<double>& best = curve.runs[i];
        REQUIRE(best.size() == 60);
        CHECK(std::ranges::is_sorted(best));
        CHECK(best.back() <= 20);
        const auto reached = static_cast<std::size_t>(std::ranges::find(best, 20.0) - best.begin());
        CHECK(std::min<std::size_t>(reached + 1, 60) == generations_to_target(ones, 2, 10, 60, seeds[i]));
    }
}

TEST_CASE("the best so far of one island is that of all islands") {
    test::ReplayInMemory replay(1);
    const ConvergenceCurve one = study_convergence(replay.context, ones, 1, 20, 25);
    REQUIRE(one.runs.at(0).size() == 25);
    CHECK(std::ranges::is_sorted(one.runs[0]));
    CHECK(one.runs[0].front() >= 10); // the best of 20 strings of 20 bits
}

TEST_CASE("a run that takes as long as the limit has not reached the target") {
    const TaskStudy study = study_of_four({500, 12, 499, 500});
    CHECK(study.reached(0) == 2);
    CHECK(study.reached_percent(0) == 50);
    CHECK(study.median(0) == 499.5);
    CHECK(study_of_four({500, 500, 500, 500}).reached(0) == 0);
}

TEST_CASE("a table of tasks has a row for each task and size, with the median and the share of runs") {
    TaskStudy two_sizes{.task = {"trap", 24}, .sizes = {96, 6}, .limit = 9, .taken = {{1, 2, 3}, {9, 9, 4}}};
    const Comparison table = tasks_comparison("table", {study_of_four({1, 3, 500, 7}), two_sizes}, "generations", 1,
                                              [](std::size_t size) { return "islands of " + std::to_string(size); });
    REQUIRE(table.cells.size() == 6);
    CHECK(table.cells[0].row == "foxholes, islands of 96");
    CHECK(table.cells[0].simulated == 5);
    CHECK(table.cells[1].column == "reached [%]");
    CHECK(table.cells[1].simulated == 75);
    CHECK(table.cells[4].row == "trap, islands of 6");
    CHECK(table.cells[4].simulated == 9);
    CHECK(table.cells[5].simulated == doctest::Approx(100 / 3.0));
    CHECK(std::ranges::none_of(table.cells, &Cell::is_judged));
}

TEST_CASE("a curve leaves out a size at which at most nine of ten runs reach the target") {
    TaskStudy nine{.task = {"trap", 24}, .sizes = {5}, .limit = 50, .taken = {std::vector<double>(10, 7)}};
    nine.taken[0][3] = 50;
    CHECK(taken_panel("", {}, {}, {nine}).series.empty());
    nine.taken[0][3] = 49;
    const Panel panel = taken_panel("title", {}, {}, {nine});
    REQUIRE(panel.series.size() == 1);
    CHECK(panel.title == "title");
    CHECK(panel.series[0].points.at(0).y == 7);
    CHECK(reached_panel("", {}, {nine}).series.at(0).points.at(0).y == 100);
}
