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

/// Returns the instruction that a report of an error should name: usually the instruction with the error, but in a
/// library routine the call of the routine. The call is returned in two cases. In the first, the table's text for the
/// error is "called from {w+12}": the call's return address is 12 words above the workspace. In the second, the table
/// has a text for errors of the call, but no rows for the code of the routine.
ErrorNote error_to_name(const Core&, const ErrorNote&, const CodeLines&);

} // namespace placedpar::transputer
