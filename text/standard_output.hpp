#pragma once

#include <string_view>

namespace placedpar {

/// Writes to standard output, at once. Throws UserError when it could not be written whole: everything that a command
/// prints goes through here, so that a report that a full disk has lost is not taken for a success.
void print_out(std::string_view text);

} // namespace placedpar
