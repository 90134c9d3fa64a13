#pragma once

#include "occam/language/tree.hpp"

#include <functional>

namespace placedpar::occam {

/// A function that may change the value of a VAL, so that options can change a program. It is called for each
/// declaration at the outermost level of the program, after the check of the declaration and before later text uses it.
using ChangeDeclaration = std::function<void(Program&, Declaration&)>;

} // namespace placedpar::occam
