#pragma once

#include "occam/language/tree.hpp"

#include <cstddef>
#include <string>
#include <utility>

namespace placedpar::editor {

/// Returns the name at a place or directly before it, and the column of the name's first character.
std::pair<std::string, std::size_t> name_at(const SourceFile&, const Location&);
/// Returns the declaration of the name at a place of the main file; null if there is no name, or if the name is not
/// declared.
const occam::Declaration* meaning_at(const occam::Program&, const Location&);

} // namespace placedpar::editor
