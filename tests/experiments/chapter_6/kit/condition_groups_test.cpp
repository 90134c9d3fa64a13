// Tests groups of conditions, and runs of single searches and of pairs on the plant.

#include "experiments/chapter_6/kit/conditions.hpp"

#include "tests/experiments/kit/replay_in_memory.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace placedpar;

namespace {

/// A search of six strings, which takes milliseconds.
PlantSearch tiny_search(std::size_t field_bits = 7) { return {plant_settings(6), plant_reading(field_bits)}; }

CoarseFineSettings tiny_pair(std::size_t field_bits) {
    const Recoding coarse = plant_reading(field_bits);
    return {plant_settings(6), plant_settings(6), coarse, coarse.bits};
}

std::vector<std::string> names_of_rows(const Comparison& table) {
    std::vector<std::string> rows;
    for (const Cell& cell : table.cells)
        if (rows.empty() || rows.back() != cell.row)
            rows.push_back(cell.row);
    return rows;
}

} // namespace

TEST_CASE("a tally of searches counts the outcomes of the search with each seed") {
    test::ReplayInMemory replay(4);
    const PlantSearch search{plant_settings(30), plant_reading(7, Coding::gray)};
    const Tally tally = tally_search(replay.context, "30 strings", search);
    std::vector<double> converged_at;
    std::size_t converged = 0;
    for (std::uint64_t seed : seeds_of(replay.context)) {
        const PlantOutcome outcome = run_plant_search(search, seed);
        converged += outcome.converged();
        converged_at.push_back(outcome.converged_at);
    }
    CHECK(tally.runs == 4);
    CHECK(tally.converged == converged);
    CHECK(tally.converged_at == converged_at);
    CHECK(replay.told.front() == "30 strings: 0 of 4 seeds");
}

TEST_CASE("a group has a row of shares for each condition, and a row of gains for each but the first") {
    test::ReplayInMemory replay(2);
    const ConditionGroup group = compare_conditions(replay.context, "six strings", "seven bits",
                                                    {{"seven", tiny_search(), {.converged = 50, .followed = {}}},
                                                     {"five", tiny_search(5)},
                                                     {"four", tiny_search(4)}});
    CHECK(names_of_rows(group.shares) == std::vector<std::string>{"seven", "five", "four"});
    CHECK(names_of_rows(group.gains) == std::vector<std::string>{"five", "four"});
    CHECK(group.shares.name == "six strings");
    CHECK(group.shares.judged);
    CHECK_FALSE(group.gains.judged);
    CHECK(group.gains.name == "six strings: percentage points above seven bits");
    REQUIRE(group.tallies.size() == 3);
    CHECK(group.tallies[2].name == "four");
    CHECK(replay.told.front() == "six strings, seven: 0 of 2 seeds");
    CHECK(std::ranges::count_if(group.shares.cells, &Cell::is_judged) == 1); // only the expected share
}

TEST_CASE("a share that is far from the expected one misses, and so does the group") {
    test::ReplayInMemory replay(30);
    const auto never = [](std::uint64_t) { return PlantOutcome{{9, 9, 9}, 200}; };
    const Tally tally = tally_runs(replay.context, "never", never);
    Comparison expects_most, expects_few;
    add_tally(expects_most, tally, {.converged = 95, .followed = {}});
    add_tally(expects_few, tally, {.converged = 3, .followed = 0});
    CHECK_FALSE(expects_most.within_tolerance());
    CHECK(expects_few.within_tolerance());
}

TEST_CASE("a condition compared with itself has gain 0: the interval contains 0 and is symmetric") {
    const Tally half{"half", 40, 20, 20, std::vector<double>(40, 10)};
    Comparison gains;
    add_gain(gains, half, half);
    const double low = figure_in(gains, "half", "converged >="), high = figure_in(gains, "half", "converged <=");
    CHECK(low < 0);
    CHECK(high == doctest::Approx(-low));
}

TEST_CASE("a figure is found by its row and its column") {
    Comparison table;
    for (const char* row : {"x", "y"})
        for (const char* column : {"a", "b"})
            table.add(plain_cell(row, column, "", *row * 1000 + *column, 0));
    CHECK(figure_in(table, "x", "b") == 'x' * 1000 + 'b');
    CHECK(figure_in(table, "y", "a") == 'y' * 1000 + 'a');
}

TEST_CASE("the settings of chapter 6 are those of chapter 5: B = 10, a window of 30, one elite, .8 and .01") {
    const SearchSettings settings = plant_settings(50);
    CHECK(settings.population == 50);
    CHECK(settings.elite == 1);
    CHECK(settings.crossover_probability == 0.8);
    CHECK(settings.mutation_probability == 0.01);
    CHECK(settings.window.length == 30);
    CHECK(settings.window.bias == 10);
    CHECK(settings.window.trials == 3);
}

TEST_CASE("the coarse reading of Table 6.3 has the highest bits of each parameter, and all bits of the delay") {
    const Recoding four = plant_reading(4);
    CHECK(four.length() == 22); // as in Table 6.4
    CHECK(plant_reading(5).length() == 27);
    CHECK(four.problem_length() == 37);
    Genome ones(22);
    ones.set_field(0, 22, (1u << 22) - 1);
    const Genome read = four.to_problem(ones);
    CHECK(read.field(0, 2) == 3);
    for (std::size_t parameter = 0; parameter < 5; ++parameter)
        CHECK(read.field(2 + 7 * parameter, 7) == 0b1111000);
}

TEST_CASE("a pair has an outcome for each of its searches, and a seed gives one pair of outcomes") {
    const PairOutcome one = run_plant_pair(tiny_pair(4), 3), same = run_plant_pair(tiny_pair(4), 3),
                      other = run_plant_pair(tiny_pair(4), 4);
    CHECK(one.coarse.pole_error == same.coarse.pole_error);
    CHECK(one.fine.pole_error == same.fine.pole_error);
    CHECK(one.fine.pole_error != other.fine.pole_error);
    for (double error : one.fine.pole_error) {
        CHECK(error >= 0);
        CHECK(error < std::hypot(2, 2)); // alpha and beta are between -1 and 1
    }
}

TEST_CASE("if the fine search has all bits, it does not depend on the bias point, and its errors are its own") {
    CoarseFineSettings settings = tiny_pair(4);
    settings.fine_bits = plant_field_bits();
    CoarseFineSettings coarser = tiny_pair(2);
    coarser.fine_bits = plant_field_bits();
    CHECK(run_plant_pair(settings, 3).fine.pole_error == run_plant_pair(coarser, 3).fine.pole_error);
    CHECK(run_plant_pair(settings, 3).coarse.pole_error != run_plant_pair(coarser, 3).coarse.pole_error);
}

TEST_CASE("a spread start changes the search, and the seed decides the rest") {
    PlantSearch spread = tiny_search();
    spread.spread_start = true;
    CHECK(run_plant_search(spread, 1).pole_error == run_plant_search(spread, 1).pole_error);
    CHECK(run_plant_search(spread, 1).pole_error != run_plant_search(tiny_search(), 1).pole_error);
}
