#pragma once

#include "gaprocs/problem_registry.hpp"
#include "gaprocs/search_observer.hpp"
#include "netlist/kinds/catalogue.hpp"

#include <cstdint>
#include <functional>
#include <vector>

namespace placedpar {

class Checkpoints; // gaprocs/checkpoints.hpp

/// Returns the search problems that this program knows, with their records of simulated measurements. The noise in the
/// records depends on the seed. A record is simulated when a process first reads it. `around` is applied to each family
/// that add_own_problems() has added.
ProblemRegistry known_problems(std::uint64_t seed,
                               const std::function<ProblemFamily(const ProblemFamily&)>& around = std::identity{});

/// Returns every process kind that this program knows. Searches report to the observer if it is not null, and continue
/// from the checkpoints if these are not null. All arguments must outlive every run.
Catalogue known_kinds(const ProblemRegistry& problems, SearchObserver* observer = nullptr,
                      Checkpoints* checkpoints = nullptr);

/// Adds the kinds of a program that is built on PlacedPar to the known kinds. REQUIRES: called by one thread before any
/// other function of this file.
void add_own_kinds(std::vector<ProcessKind>);
void add_own_devices(std::vector<DeviceKind>);
/// Adds search problems. REQUIRES: see add_own_kinds().
void add_own_problems(std::vector<ProblemFamily>);

} // namespace placedpar
