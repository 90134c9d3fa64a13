// Tests the mean differences between two algorithms and their 95 % intervals, by examples worked out by hand.

#include "experiments/chapter_4/kit/parallel_identification.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

using namespace placedpar;

namespace {

constexpr double compliance = 0.01;

/// Returns results that differ only in the generations until they are near the truth.
std::vector<FoundInRecord> found_after(const std::vector<double>& generations) {
    std::vector<FoundInRecord> found;
    for (double each : generations)
        found.push_back({compliance, each, 1});
    return found;
}

/// Returns results with these errors relative to the true compliance.
std::vector<FoundInRecord> found_off_by(const std::vector<double>& errors) {
    std::vector<FoundInRecord> found;
    for (double each : errors)
        found.push_back({compliance * (1 + each), 10, 1});
    return found;
}

std::vector<Cell> differences(std::vector<FoundInRecord> traditional, std::vector<FoundInRecord> parallel) {
    return cells_of_difference({compliance, std::move(traditional), std::move(parallel)}, "PGA");
}

enum DifferenceCell : std::size_t { near_cell, compliance_cell, generations_cell };

} // namespace

TEST_CASE("differences of 1, 2, 3, 4 and 5 generations: 3 plus or minus 1.96 sqrt(2.5 / 5)") {
    const Cell cell =
        differences(found_after({10, 10, 20, 20, 30}), found_after({11, 12, 23, 24, 35}))[generations_cell];
    CHECK(cell.simulated == 3);
    CHECK(cell.interval->low == doctest::Approx(3 - 1.96 * std::sqrt(0.5)));
    CHECK(cell.interval->high == doctest::Approx(3 + 1.96 * std::sqrt(0.5)));
    CHECK(cell.column == "PGA");
    CHECK(cell.unit == "generations");
}

TEST_CASE("a difference is the parallel algorithm's figure minus the traditional one's, record by record") {
    const auto fast = found_after({10, 20}), slow = found_after({13, 23});
    CHECK(differences(fast, slow)[generations_cell].simulated == 3);
    CHECK(differences(slow, fast)[generations_cell].simulated == -3);
    // Equal differences have an interval without width, although the records differ.
    CHECK(differences(fast, slow)[generations_cell].interval->high == 3);
}

TEST_CASE("five generations more are allowed, and fewer always") {
    const auto at_10 = found_after({10, 10, 10}), at_15 = found_after({15, 15, 15}), at_16 = found_after({16, 16, 16});
    CHECK(differences(at_10, at_15)[generations_cell].within_tolerance());
    CHECK_FALSE(differences(at_10, at_16)[generations_cell].within_tolerance());
    CHECK(differences(at_16, at_10)[generations_cell].within_tolerance());
}

TEST_CASE("a few records cannot refute: the interval must be beyond the bound as a whole") {
    const auto at_10 = found_after({10, 10, 10}),
               scattered = found_after({11, 16, 30}); // 9 generations later on average
    const Cell cell = differences(at_10, scattered)[generations_cell];
    CHECK(cell.simulated == 9);
    CHECK(cell.interval->low < 5);
    CHECK(cell.within_tolerance());
    std::vector<FoundInRecord> many_at_10, many_scattered; // the same scatter in 90 records
    for (int i = 0; i < 30; ++i)
        for (std::size_t j = 0; j < 3; ++j) {
            many_at_10.push_back(at_10[j]);
            many_scattered.push_back(scattered[j]);
        }
    CHECK_FALSE(differences(many_at_10, many_scattered)[generations_cell].within_tolerance());
}

TEST_CASE("an answer is near the truth if it is off by at most 10 %, too high or too low") {
    const auto right = found_off_by({0, 0, 0, 0});
    const auto near_percent = [&](const std::vector<double>& errors) {
        return differences(right, found_off_by(errors))[near_cell].simulated;
    };
    CHECK(near_percent({0.09, -0.09, 0.05, 0}) == 0);
    CHECK(near_percent({0.11, 0, 0, 0}) == -25);
    CHECK(near_percent({0.11, -0.11, 0, 0}) == -50);
    CHECK(differences(found_off_by({0.5, 0.5, 0.5, 0.5}), right)[near_cell].simulated == 100);
}

TEST_CASE("compliances may be 2 % higher or lower on average, although single ones scatter by more") {
    const auto right = found_off_by({0, 0, 0, 0});
    const auto within = [&](double mean) {
        return differences(right, found_off_by({mean - 0.05, mean + 0.05, mean - 0.05, mean + 0.05}));
    };
    for (double mean : {-0.019, 0.0, 0.019})
        CHECK(within(mean)[compliance_cell].within_tolerance());
    CHECK(within(0.019)[compliance_cell].simulated == doctest::Approx(0.019 * compliance).epsilon(1e-6));
    const auto biased = found_off_by({0.021, 0.021, 0.021, 0.021});
    CHECK_FALSE(differences(right, biased)[compliance_cell].within_tolerance());
    CHECK_FALSE(differences(biased, right)[compliance_cell].within_tolerance());
}

TEST_CASE("a compliance that does not exist is neither near nor within its bounds") {
    const auto right = found_off_by({0, 0}), none = found_off_by({std::nan(""), std::nan("")});
    CHECK(differences(right, none)[near_cell].simulated == -100);
    CHECK_FALSE(differences(right, none)[compliance_cell].within_tolerance());
}

TEST_CASE("each difference is judged: at least -5 % of the records, at most 2 % of the truth, at most 5 generations") {
    const std::vector<Cell> cells = differences(found_after({10, 10}), found_after({10, 10}));
    REQUIRE(cells.size() == 3);
    CHECK(cells[near_cell].at_least == -5.0);
    CHECK_FALSE(cells[near_cell].at_most);
    CHECK(*cells[compliance_cell].at_least == doctest::Approx(-0.0002));
    CHECK(*cells[compliance_cell].at_most == doctest::Approx(0.0002));
    CHECK(cells[generations_cell].at_most == 5.0);
    for (const Cell& cell : cells)
        CHECK(cell.within_tolerance());
}
