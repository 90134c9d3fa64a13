#pragma once

#include "runtime/transputer/code_lines.hpp"
#include "runtime/transputer/core.hpp"

#include <string>

namespace placedpar::transputer {

/// Describes the error of an instruction that set Error or stopped its process: "overflow: 2147483647 + 1".
///
/// Uses the table's text for the instruction, if there is one. In this text, {a}, {b} and {c} stand for the registers
/// before the instruction, as signed numbers, and {ba} for the double word in two of them; {w+2} and {l+2} stand for
/// the word and the double word that begin two words above the workspace. {a-1} is register A minus 1. {/l+2} says how
/// a division by {l+2} fails: "division by zero" if this number is 0, otherwise "overflow". Other braces stay as they
/// are.
std::string print_error(const Core&, const ErrorNote&, const CodeLines&);

/// Returns the instruction to name for an error. This is the call of the routine in which the error happened, if the
/// text of the error is "called from {w+12}": the call's return address is 12 words above the workspace. It is also the
/// call if the table has a text for errors of this call, but no rows for the code of the routine. Otherwise it is the
/// instruction with the error.
ErrorNote error_to_name(const Core&, const ErrorNote&, const CodeLines&);

} // namespace placedpar::transputer
