// Tests the curve that a terminal shows during a run.

#include "app/live_curve.hpp"

#include "tests/report/small_log.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace placedpar;

namespace {

std::size_t columns_of(const std::string& line) {
    return static_cast<std::size_t>(
        std::ranges::count_if(line, [](char byte) { return (static_cast<unsigned char>(byte) & 0xc0) != 0x80; }));
}

} // namespace

TEST_CASE("the curve of five generations equals a curve drawn by hand") {
    GenerationLog log({"east"});
    for (std::uint64_t g = 1; g <= 5; ++g)
        test::tell(log, "east", g, {0, static_cast<double>(2 * g)});
    CHECK(live_curve(log, 40, 3) == std::vector<std::string>{
                                        "generation 5: best 10, mean 5, diversity",
                                        "        10 |   **",
                                        "           | **..",
                                        "         1 |*..  ",
                                        " diversity |█████",
                                        "            1   5",
                                    });
}

TEST_CASE("an empty curve and a level curve are drawn") {
    GenerationLog log({"east"});
    CHECK(state_of(log).empty());
    CHECK(live_curve(log, 40, 3) == std::vector<std::string>(6));
    test::tell(log, "east", 1, {2, 2});
    CHECK(live_curve(log, 40, 3).at(2) == "           |*");
}

TEST_CASE("a curve of many generations fits its columns and shows the last generation") {
    GenerationLog log({"east", "west"});
    for (std::uint64_t g = 1; g <= 1000; ++g)
        for (const char* search : {"east", "west"})
            test::tell(log, search, g, {-1e9 / static_cast<double>(g * g), static_cast<double>(g)});
    for (std::size_t columns : {24, 40, 79, 200}) {
        auto lines = live_curve(log, columns, 10);
        CHECK(lines.size() == 13);
        for (const std::string& line : lines)
            CHECK(columns_of(line) <= columns);
        CHECK(lines[1].back() == '*');
        CHECK(lines[1].substr(0, 10) == "      1000");
        CHECK(lines.back().ends_with("1000"));
    }
    CHECK(state_of(log) == "generation 1000: best 1000, mean 0, diversity 0.5000, between 0.2500");
}

TEST_CASE("a curve leaves out objectives that are not finite") {
    GenerationLog log({"east"});
    test::tell(log, "east", 1, {worst_fitness, worst_fitness}, std::nullopt, Goal::maximise);
    test::tell(log, "east", 2, {worst_fitness, 2}, std::nullopt, Goal::maximise);
    CHECK(live_curve(log, 40, 3).size() == 6);
}
