#pragma once

#include "gaprocs/problem_family.hpp"

#include <cstdint>

namespace placedpar {

/// Returns the problems that netlists name "plant", "plant(noise = 0.3)", "plant(lasts = 0)": identification of chapter
/// 5's plant. The default values are the defaults of PlantExperiment. `seed` determines the input and the noise of the
/// records.
ProblemFamily plant_family(std::uint64_t seed);

} // namespace placedpar
