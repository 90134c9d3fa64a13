#pragma once

#include "text/source.hpp"

#include <memory>
#include <optional>

namespace placedpar {

/// Holds the place of the first sign that a text is occam, and a hint for the user.
struct Occam {
    Location at;
    const char* hint;
};

/// Finds the first sign that a text is occam and not a netlist. Signs of a program are PROC, SEQ and #USE. Signs of a
/// configuration are PLACED PAR and PROCESSOR 0 T8 (transputer development system), or NODE and NETWORK (occam
/// toolset). A text that has only folds and `--` comments also counts as occam. The answer is reliable only if the text
/// cannot be read as a netlist.
std::optional<Occam> occam_in(const std::shared_ptr<const SourceFile>& file);

} // namespace placedpar
