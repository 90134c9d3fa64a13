#pragma once

#include "occam/check/change.hpp"
#include "occam/language/parse.hpp"

namespace placedpar::occam {

/// Checks an occam program that has been parsed. Finds the meaning of all names, the types of all expressions and the
/// values of all constants, and stores them in the members of the tree that are marked "checked"
/// (occam/language/tree.hpp). Reports violations of the language's rules. If there is no error, also checks parallel
/// usage and aliases, if the options do not turn these checks off.
void check(Program&, const SourceOptions&, Reporter&, const ChangeDeclaration& = {});

/// Returns the last procedure of the main file; null if there is none.
const Declaration* main_procedure(const Program&);

} // namespace placedpar::occam
