#pragma once

#include "occam/language/tree.hpp"

#include <string>

namespace placedpar::occam {

/// Writes declarations as text in occam, with the text of included files in place. Parsing the result gives the same
/// tree, except for the places of its parts.
std::string print(const Program&);
/// Writes the declarations of a file that another file uses.
std::string print(const Program&, const Unit&);
/// Writes an expression as a part of another expression: operations are in parentheses.
std::string print(const Expression&);
/// Writes a type, such as "[4]CHAN OF INT::[]BYTE".
std::string print(const TypeText&);

} // namespace placedpar::occam
