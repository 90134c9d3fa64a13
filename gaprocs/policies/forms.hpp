#pragma once

#include "gaprocs/policies/noun.hpp"

namespace placedpar::forms {

// What there is to decide, but not by naming a policy.

/// Of a representation that no coding makes.
Form permutation();

Noun initial_population();
Noun fitness();
Noun window();
Noun elitism();
Noun distributed_fitness();
Noun coarse_fine();
Noun farm();

} // namespace placedpar::forms
