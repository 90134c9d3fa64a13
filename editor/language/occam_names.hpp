#pragma once

#include "occam/language/tree.hpp"

#include <cstddef>
#include <string>
#include <utility>

namespace placedpar::editor {

/// Returns the name in an occam text that contains a place or ends there, and the column of its first character. The
/// name is "" if there is none.
std::pair<std::string, std::size_t> name_at(const SourceFile&, const Location&);
/// Returns the declaration of the name at a place of the program's main file; null if there is no name, or if the name
/// is not declared.
const occam::Declaration* meaning_at(const occam::Program&, const Location&);

} // namespace placedpar::editor
