#pragma once

#include "gaprocs/problem_family.hpp"

#include <cstdint>

namespace placedpar {

/// Returns the problems that netlists name "plant", "plant(noise = 0.3)", "plant(lasts = 0)": the search for the
/// parameters of the simulated plant of the thesis's chapter 5. Numbers that the name omits have the defaults of
/// PlantExperiment (problems/plant/plant_record.hpp). `seed` determines the input and the noise of the simulated
/// measurements.
ProblemFamily plant_family(std::uint64_t seed);

} // namespace placedpar
