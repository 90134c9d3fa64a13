#pragma once

#include "netlist/kinds/file_kinds.hpp"

#include <memory>

namespace placedpar::occam {

/// Returns an object that makes kinds of processes from the PROCs of files in occam, so that netlists can name these
/// files as programs (docs/reference/netlist-language.md).
std::shared_ptr<FileKinds> make_file_kinds();

} // namespace placedpar::occam
