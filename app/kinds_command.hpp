#pragma once

#include <string>

namespace placedpar {

/// `placedpar kinds`: every kind, a line each; with a name, everything about that kind. Throws
/// std::runtime_error for a name that is no kind.
std::string print_kinds();
std::string print_kind(const std::string& name);

} // namespace placedpar
