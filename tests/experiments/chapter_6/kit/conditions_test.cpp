// Tests shares of runs that converged and that followed, their intervals, and the gain of one condition over another.

#include "experiments/chapter_6/kit/conditions.hpp"

#include "tests/experiments/kit/replay_in_memory.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

using namespace placedpar;

namespace {

const Cell& cell_at(const Comparison& comparison, const std::string& column) {
    auto found = std::ranges::find(comparison.cells, column, &Cell::column);
    REQUIRE(found != comparison.cells.end());
    return *found;
}

Tally tally_with(std::size_t runs, std::size_t converged, std::size_t followed) {
    return {"bits", runs, converged, followed, std::vector<double>(runs, 40)};
}

} // namespace

TEST_CASE("a tally counts the runs that converged and that followed, with their generations") {
    test::ReplayInMemory replay(4);
    const Seeds seeds = seeds_of(replay.context);
    const Tally tally = tally_runs(replay.context, "bits", [&](std::uint64_t seed) {
        const auto i = std::ranges::find(seeds, seed) - seeds.begin();
        return PlantOutcome{{i < 3 ? 0.09 : 0.1, 9, i == 1 ? 0.01 : 0.2}, 10.0 * static_cast<double>(i)};
    });
    CHECK(tally.runs == 4);
    CHECK(tally.converged == 3);
    CHECK(tally.followed == 1);
    CHECK(tally.converged_percent() == 75);
    CHECK(tally.followed_percent() == 25);
    CHECK(tally.converged_at == std::vector<double>{0, 10, 20, 30});
}

TEST_CASE("shares have Clopper-Pearson intervals and are judged if a share is expected") {
    Comparison comparison;
    add_tally(comparison, tally_with(10, 8, 0), {.converged = 90, .followed = {}});
    CHECK(cell_at(comparison, "converged").simulated == 80);
    CHECK(cell_at(comparison, "converged >=").simulated == doctest::Approx(44.39).epsilon(1e-4)); // for 8 in 10
    CHECK(cell_at(comparison, "converged <=").simulated == doctest::Approx(97.48).epsilon(1e-4));
    CHECK(cell_at(comparison, "converged").tolerance == share_tolerance(90, 10));
    CHECK(cell_at(comparison, "followed").simulated == 0);
    CHECK(cell_at(comparison, "followed <=").simulated == doctest::Approx(30.85).epsilon(1e-4)); // for none in 10
    CHECK_FALSE(cell_at(comparison, "followed").is_judged());
    CHECK(cell_at(comparison, "generation").simulated == 40);
    CHECK(cell_at(comparison, "generation >=").simulated == 40);
    CHECK(cell_at(comparison, "generation <=").simulated == 40);
}

TEST_CASE("a gain over the control has Newcombe's interval: 56 of 70 against 48 of 80") {
    Comparison gain, loss;
    add_gain(gain, tally_with(80, 48, 48), {"better", 70, 56, 48, {}});
    CHECK(cell_at(gain, "converged >=").simulated == doctest::Approx(5.24).epsilon(1e-3));
    CHECK(cell_at(gain, "converged <=").simulated == doctest::Approx(33.39).epsilon(1e-3));
    CHECK(gain.cells.front().row == "better");
    add_gain(loss, {"better", 70, 56, 48, {}}, tally_with(80, 48, 48));
    CHECK(cell_at(loss, "converged >=").simulated == doctest::Approx(-33.39).epsilon(1e-3));
    CHECK(cell_at(loss, "converged <=").simulated == doctest::Approx(-5.24).epsilon(1e-3));
}
