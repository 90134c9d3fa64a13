#pragma once

#include "occam/code/code.hpp"
#include "occam/code/frame.hpp"

#include <vector>

namespace placedpar::occam {

/// Returns the workspaces of the first process of a program, which gets the name `name`, and of all processes that it
/// starts; if there are very many, only about the first 65,536. REQUIRES: all frames are laid out.
std::vector<CodeWorkspace> workspaces_of(const Frame& first, const std::string& name);

} // namespace placedpar::occam
