#pragma once

#include "experiments/kit/experiment.hpp"
#include "explore/netlist_run.hpp"
#include "explore/study/results.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar::test {

/// A replay with the seed 1 and this many seeds, whose runs are kept in memory.
struct ReplayInMemory {
    explicit ReplayInMemory(std::size_t seeds, const std::filesystem::path& examples = {})
        : context{examples,
                  1,
                  [this](const std::string& progress) { told.push_back(progress); },
                  [this](const std::string& warnings) { warned.push_back(warnings); },
                  interruption,
                  results,
                  seeds} {}
    ReplayInMemory(const ReplayInMemory&) = delete;
    ReplayInMemory& operator=(const ReplayInMemory&) = delete;

    std::vector<std::string> told, warned;
    Interruption interruption;
    StudyResults results{StudySource{}};
    ReplayContext context;
};

/// Runs the experiment of this name with the seed 1 and the project's examples. A study takes `seeds` seeds, or its own
/// number by default.
inline Replay replay_named(std::string_view name, std::optional<std::size_t> seeds = {}) {
    const auto& all = experiments();
    const auto found = std::ranges::find(all, name, &Experiment::name);
    REQUIRE(found != all.end());
    ReplayInMemory replay(seeds.value_or(found->seeds), std::filesystem::path(PLACEDPAR_SOURCE_DIR) / "examples");
    return found->run(replay.context);
}

/// Returns the cells of a row, in order.
inline std::vector<Cell> row_named(const Comparison& table, std::string_view row) {
    std::vector<Cell> cells;
    std::ranges::copy_if(table.cells, std::back_inserter(cells), [&](const Cell& each) { return each.row == row; });
    return cells;
}

} // namespace placedpar::test
