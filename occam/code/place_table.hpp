#pragma once

#include "occam/code/code.hpp"

#include <string>

namespace placedpar::occam {

/// Returns a table of the places that the code came from, of its procedures, errors and processes, as
/// transputer::CodeLines reads it. `code_at` is the address of the code, in bytes from MemStart.
std::string place_table(const Code&, const Program&, std::uint32_t code_at);

} // namespace placedpar::occam
