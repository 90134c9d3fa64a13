#pragma once

#include "text/source.hpp"

#include <memory>
#include <optional>

namespace placedpar {

/// Holds the place at which a text turns out to be occam, and the equivalent in a netlist.
struct Occam {
    Location at;
    const char* hint;
};

/// Finds the sign that a text is occam: a program (PROC, SEQ, #USE), a configuration of the development system (PLACED
/// PAR, PROCESSOR 0 T8) or of the occam toolset (NODE, NETWORK). A text of only folds and comments that begin with --
/// is taken for occam, too. REQUIRES, for a reliable answer: the text cannot be read as a netlist.
std::optional<Occam> occam_in(const std::shared_ptr<const SourceFile>& file);

} // namespace placedpar
