#pragma once

#include "occam/language/parse.hpp"

namespace placedpar::occam {

/// Finds the meaning of all names, the type of all expressions and the value of all constants, and reports what the
/// language does not allow. If these find no error, parallel usage and aliases are checked too, as far as the options
/// ask for it. Fills the members of the tree that are marked "checked".
void check(Program&, const SourceOptions&, Reporter&);

/// Returns the last procedure of the main file; null if there is none.
const Declaration* main_procedure(const Program&);

} // namespace placedpar::occam
