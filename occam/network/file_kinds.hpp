#pragma once

#include "netlist/kinds/file_kinds.hpp"

#include <memory>

namespace placedpar::occam {

/// Returns what makes process kinds of files in occam (docs/reference/netlist-language.md).
std::shared_ptr<FileKinds> make_file_kinds();

} // namespace placedpar::occam
