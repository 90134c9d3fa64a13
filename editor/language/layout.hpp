#pragma once

#include "text/source.hpp"

#include <memory>
#include <optional>
#include <string>

namespace placedpar::editor {

/// Returns a netlist with another layout: indentation by blocks, one blank between words, no blanks at the ends of
/// lines, at most one empty line. Words, comments and the breaks between lines stay. Returns nothing for a text that
/// the lexer refuses.
std::optional<std::string> laid_out_netlist(const std::shared_ptr<const SourceFile>&);

/// Returns a program in occam without blanks at the ends of lines, and with blanks in place of tabs in front of lines.
/// The indentation is part of the language and stays. Returns nothing if the words would change.
std::optional<std::string> laid_out_occam(const std::shared_ptr<const SourceFile>&);

} // namespace placedpar::editor
