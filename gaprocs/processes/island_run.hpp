#pragma once

#include "gaprocs/problem_registry.hpp"
#include "gaprocs/processes/archipelago.hpp"
#include "netlist/network/network.hpp"

#include <cstddef>
#include <optional>

namespace placedpar {

/// Returns samples_needed() of an island; if it is in step with others, the largest among those of its part.
std::size_t samples_awaited(const Network&, const Archipelago&, std::size_t island);
/// Returns the number of samples that a ga.host sends to the process; for an objective problem, whose samples are
/// empty, the number of generations. Returns nothing if the samples come from another kind of process, or the problem
/// does not exist.
std::optional<std::size_t> samples_sent_to(const Network&, std::size_t process, const ProblemRegistry&);

/// How long an island searches.
struct IslandRun {
    std::size_t samples; ///< samples received
    std::size_t first;   ///< samples received before the first generation
    std::size_t trials;  ///< generations for each sample from then on

    std::size_t generations() const { return samples < first ? 0 : (samples - first + 1) * trials; }
    /// Returns how many samples have been received when a generation is made. Generations count from 1.
    std::size_t samples_at(std::size_t generation) const { return first + (generation - 1) / trials; }
};

/// Reads the run of an island from the netlist; nothing if samples_sent_to() returns nothing.
std::optional<IslandRun> run_of(const Network&, const Archipelago&, std::size_t island, const ProblemRegistry&);

} // namespace placedpar
