#pragma once

#include "gaprocs/policies/noun.hpp"

/// What a netlist says otherwise than by naming a policy: by a number, a file, the problem, what it connects.
namespace placedpar::forms {

// Of nouns that have policies besides; in forms.cpp.

Form permutation(); ///< of a representation: no coding makes it
Form predefined();  ///< of an initial population

// Nouns that have no policy, each in a file of its own.

Noun fitness();             ///< in fitness.cpp
Noun window();              ///< in window.cpp
Noun elitism();             ///< in elitism.cpp
Noun distributed_fitness(); ///< in distributed_fitness.cpp
Noun coarse_fine();         ///< in coarse_fine.cpp
Noun farm();                ///< in farm.cpp

} // namespace placedpar::forms
