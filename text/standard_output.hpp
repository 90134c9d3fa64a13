#pragma once

#include <string_view>

namespace placedpar {

/// Writes to standard output, at once: everything that a command prints goes this way, so that a report lost on its
/// way to a full disk is no success. Throws UserError when it could not be written whole.
void print_out(std::string_view text);

} // namespace placedpar
