#pragma once

#include "gaprocs/generation_log.hpp"
#include "gaprocs/objective.hpp"

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace placedpar::test {

/// Logs a generation of two strings of two bits that differ in one bit.
inline void tell(GenerationLog& log, std::string_view search, std::uint64_t number, std::vector<double> fitness,
                 std::optional<Time> time = std::nullopt, std::optional<Goal> goal = std::nullopt) {
    std::vector<Genome> population{Genome::from_string("00"), Genome::from_string("01")};
    log.observe({search, number, time, BitString(2), population, fitness, goal});
}

} // namespace placedpar::test
