#include "experiments/chapter_5/kit/maximisation.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace placedpar;

TEST_CASE("a target that everyone has is reached at once, one that nobody can have never") {
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

TEST_CASE("every task can be reached") {
    for (const StaticTask& task : static_tasks()) {
        std::size_t best = 500;
        for (std::uint64_t seed = 1; seed <= 5; ++seed)
            best = std::min(best, generations_to_target(task, 1, 200, 500, seed));
        CAPTURE(task.problem);
        CHECK(best < 500);
    }
}
