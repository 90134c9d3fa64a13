#pragma once

#include "text/source.hpp"

#include <memory>
#include <optional>
#include <string>

namespace placedpar {

/// Returns a netlist with another layout: indentation by blocks, one blank between words, no blanks at the ends of
/// lines, at most one empty line. Words, comments and the breaks between lines stay. Returns nothing for a text with an
/// error in its syntax.
std::optional<std::string> laid_out_netlist(const std::shared_ptr<const SourceFile>&);

} // namespace placedpar
