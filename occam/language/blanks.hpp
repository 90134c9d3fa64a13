#pragma once

#include "text/source.hpp"

#include <memory>
#include <optional>
#include <string>

namespace placedpar::occam {

/// Returns a program without blanks at the ends of lines, and with blanks in place of tabs in front of lines. The
/// indentation is part of the language and stays. Returns nothing if the words would change.
std::optional<std::string> with_tidy_blanks(const std::shared_ptr<const SourceFile>&);

} // namespace placedpar::occam
