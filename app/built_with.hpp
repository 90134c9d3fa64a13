#pragma once

namespace placedpar {

/// A text with the compiler and the libraries of this build, and their versions.
extern const char* const built_with;

} // namespace placedpar
