#pragma once

#include "occam/code/code.hpp"

#include <string>

namespace placedpar::occam {

/// Returns a table with which reports name places in the source, procedures, errors and processes of running code. It
/// has the format of transputer::CodeLines. `code_at` is the address of the code, in bytes from MemStart.
std::string place_table(const Code&, const Program&, std::uint32_t code_at);

} // namespace placedpar::occam
