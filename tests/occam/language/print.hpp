#pragma once

#include "occam/language/tree.hpp"

#include <string>

namespace placedpar::occam {

/// Writes declarations as a text of occam, with the files that they include in place. A parser reads it as the same
/// tree, but for places.
std::string print(const Program&);
/// Writes the declarations of a file that another one uses.
std::string print(const Program&, const Unit&);
/// Writes an expression as it stands within another one: operations are in parentheses.
std::string print(const Expression&);
/// Writes a type, such as "[4]CHAN OF INT::[]BYTE".
std::string print(const TypeText&);

} // namespace placedpar::occam
