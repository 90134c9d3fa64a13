#pragma once

#include "experiments/kit/experiment.hpp"
#include "explore/netlist_run.hpp"
#include "explore/study/results.hpp"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace placedpar::test {

/// A replay with the seed 1 over so many seeds, whose runs are kept in memory.
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

} // namespace placedpar::test
