#pragma once

#include "text/source.hpp"

#include <memory>
#include <optional>
#include <string>

namespace placedpar::occam {

/// Returns the program without blanks at the ends of lines, and with blanks instead of tabs at the beginnings of lines.
/// The depth of indentation stays, since it is part of the language. Returns nothing if the words of the program would
/// change.
std::optional<std::string> with_tidy_blanks(const std::shared_ptr<const SourceFile>&);

} // namespace placedpar::occam
