// Tests equation 6.2: which share of schemata survives crossover and mutation, by defining length.

#include "tests/experiments/kit/replay_in_memory.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <string>

using namespace placedpar;

namespace {

/// Returns the only cell of a row and a column.
Cell cell_in(const Comparison& table, const std::string& row, const std::string& column) {
    for (const Cell& cell : table.cells)
        if (cell.row == row && cell.column == column)
            return cell;
    FAIL("no cell of " << row << ", " << column);
    return {};
}

std::string row_of_length(int length) {
    return length == 0 ? "order 1" : fmt::format("order 2, defining length {}", length);
}

} // namespace

TEST_CASE("by equation 6.2 a share (1 - .8 d / 7) .99^n of schemata of defining length d and order n survives") {
    const Replay replay = test::replay_named("schemata", 20);
    const Comparison& survival = replay.comparisons.at(2);
    for (int length = 0; length <= 7; ++length) {
        const Cell cell = cell_in(survival, row_of_length(length), "rates .8 and .01");
        REQUIRE(cell.reference);
        CHECK(*cell.reference == doctest::Approx((1 - 0.8 * length / 7) * (length == 0 ? 0.99 : 0.99 * 0.99)));
        CHECK(cell.simulated > 0.98 * *cell.reference); // the equation is a lower bound
    }
    CHECK(cell_in(survival, row_of_length(7), "rates .8 and .01").simulated <
          cell_in(survival, row_of_length(1), "rates .8 and .01").simulated);
}

TEST_CASE("reproduction alone gives the expected number of strings of a schema, whatever its defining length") {
    const Replay replay = test::replay_named("schemata", 20);
    for (const Comparison* table : {&replay.comparisons.at(0), &replay.comparisons.at(1)}) // the fit schema, the others
        for (int length = 0; length <= 7; ++length)
            CHECK(cell_in(*table, row_of_length(length), "reproduction alone").simulated ==
                  doctest::Approx(1).epsilon(0.06));
}
