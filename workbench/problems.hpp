#pragma once

#include "gaprocs/problem_registry.hpp"
#include "netlist/kinds/catalogue.hpp"

#include <cstdint>

namespace placedpar {

/// The search problems that this program knows, with the records they are searched over; the noise in the
/// measurements depends on the seed. A record is simulated when a process first reads it.
ProblemRegistry known_problems(std::uint64_t seed);

/// Every process kind that this program knows. `problems` must outlive every run.
Catalogue known_kinds(const ProblemRegistry& problems);

} // namespace placedpar
