#pragma once

#include "text/source.hpp"

#include <memory>
#include <optional>

namespace placedpar {

/// Says at which place a text turns out to be occam, and has a hint for the user.
struct Occam {
    Location at;
    const char* hint;
};

/// Finds the first sign that a text is occam: a program (PROC, SEQ, #USE), or a configuration of the development system
/// (PLACED PAR, PROCESSOR 0 T8) or of the occam toolset (NODE, NETWORK). A text that has only folds and `--` comments
/// also counts as occam. The answer is reliable only if the text cannot be read as a netlist.
std::optional<Occam> occam_in(const std::shared_ptr<const SourceFile>& file);

} // namespace placedpar
