#pragma once

namespace placedpar {

/// The compiler and the libraries that the program was built with, with their versions.
extern const char* const built_with;

} // namespace placedpar
