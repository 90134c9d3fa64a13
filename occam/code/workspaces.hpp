#pragma once

#include "occam/code/code.hpp"
#include "occam/code/frame.hpp"

#include <vector>

namespace placedpar::occam {

/// Returns the workspaces of the processes that the first process of a program starts, at most some 65,536 of them.
/// REQUIRES: all frames are laid out.
std::vector<CodeWorkspace> workspaces_of(const Frame& first);

} // namespace placedpar::occam
