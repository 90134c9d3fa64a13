#pragma once

#include "occam/language/parse.hpp"

namespace placedpar::occam {

/// Finds the meaning of all names, the types of all expressions and the values of all constants. Reports violations of
/// the language's rules. If there is no error, also checks parallel usage and aliases, unless the options turn these
/// checks off. Fills the members of the tree that are marked "checked".
void check(Program&, const SourceOptions&, Reporter&);

/// Returns the last procedure of the main file; null if there is none.
const Declaration* main_procedure(const Program&);

} // namespace placedpar::occam
