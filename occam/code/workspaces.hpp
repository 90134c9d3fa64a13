#pragma once

#include "occam/code/code.hpp"
#include "occam/code/frame.hpp"

#include <vector>

namespace placedpar::occam {

/// Returns the workspaces of the first process of a program, called `name`, and of all processes that it starts, so
/// that reports can name processes. If there are more than about 65,536, the others are left out. REQUIRES: all frames
/// are laid out.
std::vector<CodeWorkspace> workspaces_of(const Frame& first, const std::string& name);

} // namespace placedpar::occam
