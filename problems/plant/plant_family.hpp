#pragma once

#include "gaprocs/problem_family.hpp"

#include <cstdint>

namespace placedpar {

/// Identification of chapter 5's plant as netlists name it: "plant", "plant(noise = 0.3)", "plant(lasts = 0)". The
/// defaults are those of PlantExperiment. `seed` determines the records.
ProblemFamily plant_family(std::uint64_t seed);

} // namespace placedpar
