#pragma once

#include "runtime/transputer/code_lines.hpp"
#include "runtime/transputer/core.hpp"

#include <string>

namespace placedpar::transputer {

/// Says what an instruction that has set Error, or stopped its process, has found: "overflow: 2147483647 + 1".
///
/// If the table has a text for it, that text is used. In it, {a}, {b} and {c} stand for the registers that the
/// instruction found, as signed numbers, and {ba} for the double word in two of them; {w+2} and {l+2} stand for the
/// word and the double word that begin two words above its workspace. {a-1} is 1 less. Other braces stay as they are.
std::string print_error(const Core&, const ErrorNote&, const CodeLines&);

/// Returns the call of the routine in which an error has happened, as the instruction to name. It does so if the text
/// of the error is "called from {w+12}": the call's return address is 12 words above the workspace. It also does if the
/// table has a text for errors of this call, but nothing about the code of the routine. Returns the error itself
/// otherwise.
ErrorNote error_to_name(const Core&, const ErrorNote&, const CodeLines&);

} // namespace placedpar::transputer
