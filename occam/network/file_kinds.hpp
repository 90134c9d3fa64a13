#pragma once

#include "netlist/kinds/file_kinds.hpp"

#include <memory>

namespace placedpar::occam {

/// Returns an object that makes process kinds from files in occam (docs/reference/netlist-language.md).
std::shared_ptr<FileKinds> make_file_kinds();

} // namespace placedpar::occam
