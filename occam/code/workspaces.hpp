#pragma once

#include "occam/code/code.hpp"
#include "occam/code/frame.hpp"

#include <vector>

namespace placedpar::occam {

/// Returns the workspaces of the first process of a program, named `name`, and of the processes that it starts. Returns
/// at most about 65,536 workspaces. REQUIRES: all frames are laid out.
std::vector<CodeWorkspace> workspaces_of(const Frame& first, const std::string& name);

} // namespace placedpar::occam
