// Tests the cost of a search over the cost of recursive least squares, with operations counted by hand.

#include "experiments/chapter_5/kit/computation.hpp"

#include "tests/experiments/kit/replay_in_memory.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace placedpar;

namespace {

/// Returns the figure of a search with this window and this number of generations for each sample.
Cell cost_of_search(const Comparison& table, int window, int per_sample, const std::string& column) {
    const std::string row =
        "window " + std::to_string(window) + ", generations a sample: " + std::to_string(per_sample);
    for (const Cell& cell : test::row_named(table, row))
        if (cell.column == column)
            return cell;
    FAIL("no cell of " << row << ", " << column);
    return {};
}

} // namespace

TEST_CASE("an addition, a multiplication and a division take 10, 15 and 20 cycles of a T800 with their operands") {
    CHECK(Operations{1, 0, 0}.t800_cycles() == 10);
    CHECK(Operations{0, 1, 0}.t800_cycles() == 15);
    CHECK(Operations{0, 0, 1}.t800_cycles() == 20);
    CHECK(Operations{3, 2, 1}.t800_cycles() == 3 * 10 + 2 * 15 + 20);
    CHECK(Operations{3, 2, 1}.all() == 6);
}

TEST_CASE("a fitness over ten samples takes 212 operations, and a recursion of five unknowns 128") {
    const Operations fitness = operations_of_fitness(10), recursion = operations_of_recursion(5);
    CHECK(fitness.additions == 108);
    CHECK(fitness.multiplications == 104);
    CHECK(fitness.divisions == 0);
    CHECK(recursion.additions == 25 + 10 + 15 + 1);
    CHECK(recursion.multiplications == 25 + 15 + 15 + 2);
    CHECK(recursion.divisions == 5 + 15);
    CHECK(recursion.all() == 128);
    CHECK(operations_of_fitness(0).additions == 8); // only the weights
}

TEST_CASE("a search costs as many recursions as its individuals, its window and its generations make") {
    test::ReplayInMemory replay(1);
    const std::vector<Comparison> tables = computation_comparisons(replay.context);
    REQUIRE(tables.size() == 2);
    const auto operations = [&](int window, int per_sample) {
        return cost_of_search(tables[0], window, per_sample, "times the operations");
    };
    // 100 individuals against recursions for four delays
    CHECK(operations(10, 1).simulated == doctest::Approx(100 * 212 / (4 * 128.0)));
    CHECK(operations(30, 1).simulated == doctest::Approx(100 * (8 + 300 + 14 + 270) / (4 * 128.0)));
    CHECK(operations(10, 3).simulated == doctest::Approx(3 * operations(10, 1).simulated));
    CHECK(operations(30, 3).simulated == doctest::Approx(3 * operations(30, 1).simulated));
    const double recursion_cycles = 51 * 10 + 57 * 15 + 20 * 20;
    CHECK(cost_of_search(tables[0], 10, 1, "times the T800's cycles").simulated ==
          doctest::Approx(100 * (108 * 10 + 104 * 15 + 1750) / (4 * recursion_cycles)));
}

TEST_CASE("only the short window with one generation a sample is 30 to 50 times as expensive, as the thesis has it") {
    test::ReplayInMemory replay(1);
    const std::vector<Comparison> tables = computation_comparisons(replay.context);
    for (const Cell& cell : tables.at(0).cells) {
        CAPTURE(cell.row);
        CAPTURE(cell.column);
        const bool as_claimed =
            cell.row == "window 10, generations a sample: 1" && cell.column == "times the operations";
        CHECK((cell.simulated >= 30 && cell.simulated <= 50) == as_claimed);
        CHECK(cell.at_most.has_value() == as_claimed);
        CHECK(cell.within_tolerance());
    }
    CHECK(tables.at(1).notes.find("claimed at least 30 and at most 50: undecided") != std::string::npos); // one seed
    CHECK(tables.at(1).within_tolerance());
}
