#pragma once

#include "app/options.hpp"
#include "explore/occam_program.hpp"

namespace placedpar {

/// Declares the options of a command that compiles occam.
void add_occam(Options&, OccamOptions&);

} // namespace placedpar
