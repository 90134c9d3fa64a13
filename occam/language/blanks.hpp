#pragma once

#include "text/source.hpp"

#include <memory>
#include <optional>
#include <string>

namespace placedpar::occam {

/// Returns the text of an occam program without blanks at the ends of lines, and with blanks in place of tabs at the
/// beginnings of lines. The depth of indentation stays, since it has a meaning. Returns nothing if the change would
/// alter the words of the program.
std::optional<std::string> with_tidy_blanks(const std::shared_ptr<const SourceFile>&);

} // namespace placedpar::occam
