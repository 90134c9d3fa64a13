#pragma once

#include "gaprocs/problem_registry.hpp"
#include "gaprocs/search_observer.hpp"
#include "netlist/kinds/catalogue.hpp"

#include <cstdint>
#include <functional>
#include <vector>

namespace placedpar {

class Checkpoints; // gaprocs/checkpoints.hpp

/// Returns the search problems that this program knows, with their simulated measurements. The noise in the
/// measurements depends on the seed. Measurements are simulated when a process first reads them. `around` changes each
/// family of problems that add_own_problems() has added, for example so that results are remembered
/// (RememberedProblems).
ProblemRegistry known_problems(std::uint64_t seed,
                               const std::function<ProblemFamily(const ProblemFamily&)>& around = std::identity{});

/// Returns every kind of processes that this program knows. Searches report to the observer if it is not null, and
/// continue from the checkpoints if these are not null. All arguments must outlive every run.
Catalogue known_kinds(const ProblemRegistry& problems, SearchObserver* observer = nullptr,
                      Checkpoints* checkpoints = nullptr);

/// Adds the kinds of processes of a user's program to the known kinds. REQUIRES: called by one thread before any other
/// function of this file.
void add_own_kinds(std::vector<ProcessKind>);
void add_own_devices(std::vector<DeviceKind>);
/// Adds a user's search problems. REQUIRES: what add_own_kinds() requires.
void add_own_problems(std::vector<ProblemFamily>);

} // namespace placedpar
