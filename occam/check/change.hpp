#pragma once

#include "occam/language/tree.hpp"

#include <functional>

namespace placedpar::occam {

/// Called for each declaration at the outermost level of a program after its check, before later text uses it. May
/// change the value of a VAL.
using ChangeDeclaration = std::function<void(Program&, Declaration&)>;

} // namespace placedpar::occam
