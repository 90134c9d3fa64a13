#pragma once

#include "occam/code/code.hpp"

#include <string>

namespace placedpar::occam {

/// Returns a table in the format of transputer::CodeLines: places in the source, procedures, errors and processes of
/// the code. `code_at` is the address of the code, in bytes from MemStart.
std::string place_table(const Code&, const Program&, std::uint32_t code_at);

} // namespace placedpar::occam
