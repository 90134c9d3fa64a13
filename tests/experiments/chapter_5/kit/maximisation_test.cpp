#include "experiments/chapter_5/kit/maximisation.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace placedpar;

TEST_CASE("a target that every string meets is reached at once, an impossible target never") {
    CHECK(generations_to_target({"one-max(bits = 60)", 0}, 4, 24, 20, 1) == 1);
    CHECK(generations_to_target({"one-max(bits = 60)", 61}, 4, 24, 20, 1) == 20);
    CHECK(generations_to_target({"foxholes", 500}, 1, 30, 20, 1) == 1);
    CHECK(generations_to_target({"foxholes", 0.99}, 1, 30, 20, 1) == 20);
}

TEST_CASE("a higher target is never reached sooner, and a seed gives one answer") {
    std::size_t before = 0;
    for (double target : {30, 40, 50, 55, 60}) {
        std::size_t generations = generations_to_target({"one-max(bits = 60)", target}, 4, 24, 200, 3);
        CHECK(generations >= before);
        CHECK(generations == generations_to_target({"one-max(bits = 60)", target}, 4, 24, 200, 3));
        before = generations;
    }
    CHECK(before < 200);
}

TEST_CASE("every task's target can be reached") {
    for (const StaticTask& task : static_tasks()) {
        std::size_t best = 500;
        for (std::uint64_t seed = 1; seed <= 5; ++seed)
            best = std::min(best, generations_to_target(task, 1, 200, 500, seed));
        CAPTURE(task.problem);
        CHECK(best < 500);
    }
}

TEST_CASE("curves over the size have a point with an interval at each size") {
    TaskStudy often{
        .task = {"foxholes", 1}, .sizes = {10, 20}, .limit = 100, .taken = {{4, 6, 5, 4, 6, 5}, {3, 3, 3, 3, 3, 3}}};
    TaskStudy seldom{.task = {"foxholes", 1},
                     .sizes = {10, 20},
                     .limit = 100,
                     .taken = {{100, 6, 100, 100, 6, 100}, {3, 3, 3, 3, 3, 3}}};
    const Panel reached = reached_panel("", {.from = 0, .to = 30}, {often, seldom});
    REQUIRE(reached.series.size() == 2);
    for (const Series& series : reached.series) {
        REQUIRE(series.points.size() == 2);
        CHECK(series.points[0].x == 10);
        CHECK(series.points[1].x == 20);
        REQUIRE(series.intervals.size() == 2);
        CHECK(series.intervals[0].contains(series.points[0].y));
    }
    const Panel taken = taken_panel("", {.from = 0, .to = 30}, {}, {often, seldom});
    REQUIRE(taken.series.size() == 2);
    CHECK(taken.series[0].intervals.size() == 2);
    REQUIRE(taken.series[1].points.size() == 1); // the smaller population does not reach it often enough
    CHECK(taken.series[1].points[0].x == 20);
    CHECK(taken.series[1].intervals[0].low == 3);
}
