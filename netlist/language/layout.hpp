#pragma once

#include "text/source.hpp"

#include <memory>
#include <optional>
#include <string>

namespace placedpar {

/// Returns the text of a netlist with tidy blanks: lines are indented by blocks, words are separated by one blank, and
/// at most one empty line is left between lines. Words, comments and line breaks stay. Returns nothing if the text has
/// an error in its syntax.
std::optional<std::string> laid_out_netlist(const std::shared_ptr<const SourceFile>&);

} // namespace placedpar
