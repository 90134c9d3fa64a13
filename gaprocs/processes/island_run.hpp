#pragma once

#include "gaprocs/problem_registry.hpp"
#include "gaprocs/processes/archipelago.hpp"
#include "netlist/network/network.hpp"

#include <cstddef>
#include <optional>

namespace placedpar {

/// Returns the number of samples for which an island waits before its first generation. If islands exchange in step,
/// all islands of a connected part wait for the largest number that an island of this part needs.
std::size_t samples_awaited(const Network&, const Archipelago&, std::size_t island);
/// Returns the number of samples of measurements that a ga.host sends to the process. If the problem has an objective,
/// the samples are empty, and their number is the number of generations. Returns nothing if no ga.host is connected, or
/// if the host's problem does not exist.
std::optional<std::size_t> samples_sent_to(const Network&, std::size_t process, const ProblemRegistry&);

/// Says how many generations an island's search makes, and after which sample it makes each of them.
struct IslandRun {
    std::size_t samples; ///< samples received
    std::size_t first;   ///< number of samples needed before the first generation
    std::size_t trials;  ///< number of generations after each sample

    std::size_t generations() const { return samples < first ? 0 : (samples - first + 1) * trials; }
    /// Returns the number of samples received before the generation is made. Generations are numbered from 1.
    std::size_t samples_at(std::size_t generation) const { return first + (generation - 1) / trials; }
};

/// Reads an island's run from the netlist. Returns nothing if samples_sent_to() returns nothing, or if the island's
/// problem does not exist.
std::optional<IslandRun> run_of(const Network&, const Archipelago&, std::size_t island, const ProblemRegistry&);

} // namespace placedpar
