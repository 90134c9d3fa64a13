#pragma once

#include "gaprocs/problem_registry.hpp"
#include "gaprocs/processes/archipelago.hpp"
#include "netlist/network/network.hpp"

#include <cstddef>
#include <optional>

namespace placedpar {

/// samples_needed() of an island; where it is in step with others, for the first generation of each of them.
std::size_t samples_awaited(const Network&, const Archipelago&, std::size_t island);
/// Samples that its ga.host sends a process, or as many empty ones as generations of an objective problem; nothing
/// where it is sent them by another process, or where there is no such problem.
std::optional<std::size_t> samples_sent_to(const Network&, std::size_t process, const ProblemRegistry&);

/// How long an island searches.
struct IslandRun {
    std::size_t samples; ///< that come in
    std::size_t first;   ///< with how many of them the first generation is made
    std::size_t trials;  ///< generations for each from there on

    std::size_t generations() const { return samples < first ? 0 : (samples - first + 1) * trials; }
    /// How many samples have come in when that generation is made, counted from 1.
    std::size_t samples_at(std::size_t generation) const { return first + (generation - 1) / trials; }
};

/// As a netlist says it; nothing as samples_sent_to().
std::optional<IslandRun> run_of(const Network&, const Archipelago&, std::size_t island, const ProblemRegistry&);

} // namespace placedpar
